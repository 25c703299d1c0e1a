// What is answered to a request: the site, the folder of bags, logging in, or why not.
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "runtime/remote/web/gate.hpp"
#include "runtime/remote/web/rate.hpp"
#include "runtime/remote/web/request.hpp"
#include "runtime/remote/web/request_target.hpp"
#include "runtime/remote/web/server_options.hpp"
#include "runtime/remote/web/site_file.hpp"

namespace bw::web {

/// A socket that may be opened.
struct Admission {
  std::string subprotocol;
  std::string origin;
  std::string read_only;  ///< why it may not command; empty: it may
};

class Router {
 public:
  /// Reads the token and looks for the folder of bags: throws as they do.
  Router(const ServerOptions& options, bool is_loopback, Site site, std::vector<std::string> subprotocols);
  void set_port(std::uint16_t port) { gate_.set_port(port); }
  /// What commands need where reading is free; empty: a token_file holds it.
  std::string run_token() const;

  Reply answer(const Request& request);
  /// Of an upgrade to WebSocket.
  std::variant<Admission, Reply> admit(const Request& request);

 private:
  Reply answer_let_in(const Request& request, const RequestTarget& target);
  Reply site_reply(const Request& request, const RequestTarget& target) const;
  Reply bag_reply(const Request& request, const RequestTarget& target) const;
  std::string agreed_subprotocol(const Request& request) const;

  Gate gate_;
  Site site_;
  std::unique_ptr<BagFolder> bags_;
  std::vector<std::string> subprotocols_;
  Rate handshakes_;
};

}  // namespace bw::web
