// Lets requests in: the rules about Host and Origin in every mode, and the token: for commands, or for
// everything.
#pragma once

#include <optional>
#include <string>

#include "runtime/remote/web/access.hpp"
#include "runtime/remote/web/request.hpp"
#include "runtime/remote/web/server_options.hpp"
#include "runtime/remote/web/token.hpp"

namespace bw::web {

/// Of its headers.
Caller caller_of(const Request& request);

class Gate {
 public:
  Gate(AccessRules rules, std::string token, std::size_t login_attempts);
  /// Sessions of a browser are for all ports of a machine: the port makes its cookie our own.
  void set_port(std::uint16_t port) { cookie_ = "bandwagon_" + std::to_string(port); }

  /// The answer where Host or Origin refuse it: 400, 403.
  std::optional<Reply> refuse_caller(const Request& request) const;
  /// The answer where it may not even read: 401, 429.
  std::optional<Reply> refuse_reading(const Request& request,
                                      const std::optional<std::string>& query_token = {});
  /// POST /login and /logout.
  Reply log_in(const Request& request);
  Reply log_out(const Request& request);

  /// Why the socket that is asked for may only read; empty: it may command. Of a request that was not
  /// refused; `query_token`: of its target. A wrong token is no refusal where reading is free, and is not
  /// counted: all clients there share an address, and a lockout would take the stop from the one who has the
  /// token. 128 random bits are not guessed.
  std::string read_only(const Request& request, const std::optional<std::string>& query_token) const;

  bool is_loopback() const { return rules_.is_loopback; }
  bool is_reading_free() const { return rules_.is_reading_free; }

 private:
  /// A given token: 401 or 429, or nothing when it is right.
  std::optional<Reply> judge(const std::string& given, const Request& request);
  std::string cookie_of(const Request& request) const;

  AccessRules rules_;
  std::string token_;
  std::string cookie_ = "bandwagon";
  Sessions sessions_;
  Attempts attempts_;
};

}  // namespace bw::web
