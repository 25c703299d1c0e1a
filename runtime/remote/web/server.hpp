// HTTP and WebSocket on one port. One thread reads, writes and calls the handler; it is also the Loop that
// others may post to.
//
//   Server server(options, site, {"foxglove.websocket.v1"}, logger);   // the port is bound: port() and address() are known
//   Handler handler(server, server);                                   // as SocketSender and as Loop
//   server.start(handler);
//   server.stop();                                                     // sockets are told 1001; returns within 0.5 s
//
// What is refused, is refused with an HTTP status or a WebSocket close code and its reason in words, and
// logged at debug, never with a token, a cookie or the query of a URL.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "runtime/logger.hpp"
#include "runtime/remote/web/connection.hpp"
#include "runtime/remote/web/server_options.hpp"
#include "runtime/remote/web/site_file.hpp"

namespace bw::web {

class Server : public SocketSender, public Loop {
 public:
  /// `subprotocols`: those spoken, the preferred one first. Throws std::runtime_error: an address that is
  /// none or not of this machine, no free port, no token where one is needed, a token file that others can
  /// read, a folder of bags that is none.
  Server(const ServerOptions& options, Site site, std::vector<std::string> subprotocols, Logger logger);
  ~Server() override;  ///< stops

  /// Once. `handler` is called until stop() returns.
  void start(SocketHandler& handler);
  /// Every open socket gets its on_close. Not on the server's thread.
  void stop();

  std::uint16_t port() const;
  std::string address() const;  ///< http://127.0.0.1:8765/
  /// What commands need where reading is free; empty: a token_file holds it.
  std::string run_token() const;

  void send(ConnectionId id, Frame frame, Keep keep) override;
  void close(ConnectionId id, std::uint16_t code, const std::string& reason) override;
  void post(std::function<void()> call) override;
  void after(std::chrono::milliseconds delay, std::function<void()> call) override;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace bw::web
