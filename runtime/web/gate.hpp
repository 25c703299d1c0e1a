// Lets requests in: the rules about Host and Origin in every mode, and the token where one is needed.
#pragma once

#include <optional>
#include <string>

#include "runtime/web/access.hpp"
#include "runtime/web/request.hpp"
#include "runtime/web/server_options.hpp"
#include "runtime/web/token.hpp"

namespace bw::web {

/// Of its headers.
Caller caller_of(const Request& request);

class Gate {
 public:
  /// `token` empty: none is needed.
  Gate(AccessRules rules, std::string token, std::size_t login_attempts);
  /// Sessions of a browser are for all ports of a machine: the port makes its cookie our own.
  void set_port(std::uint16_t port) { cookie_ = "bandwagon_" + std::to_string(port); }

  /// The answer where it is refused: 400, 401, 403, 429. `with_token` false: Host and Origin alone.
  std::optional<Reply> refuse(const Request& request, bool with_token = true);
  /// POST /login and /logout.
  Reply log_in(const Request& request);
  Reply log_out(const Request& request);

  const AccessRules& rules() const { return rules_; }
  bool needs_token() const { return !token_.empty(); }

 private:
  std::optional<Reply> refuse_without_token(const Request& request);
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
