// A handler that keeps what it hears, and a server with it.
#pragma once

#include <map>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/remote/web/server.hpp"
#include "tests/interop/eventually.hpp"

namespace bw::test {

class RecordingHandler : public web::SocketHandler {
 public:
  void on_open(web::ConnectionId id, const web::Opening& opening) override {
    const std::lock_guard lock(mutex_);
    open_.emplace(id, opening);
    last_ = id;
  }
  void on_text(web::ConnectionId, std::string_view text) override {
    const std::lock_guard lock(mutex_);
    heard_.emplace_back("text " + std::string(text));
  }
  void on_binary(web::ConnectionId, std::span<const std::uint8_t> bytes) override {
    const std::lock_guard lock(mutex_);
    heard_.emplace_back("binary " + std::string(bytes.begin(), bytes.end()));
  }
  void on_close(web::ConnectionId id) override {
    const std::lock_guard lock(mutex_);
    open_.erase(id);
    ++closed_;
  }

  std::map<web::ConnectionId, web::Opening> open() const {
    const std::lock_guard lock(mutex_);
    return open_;
  }
  std::vector<std::string> heard() const {
    const std::lock_guard lock(mutex_);
    return heard_;
  }
  int closed() const {
    const std::lock_guard lock(mutex_);
    return closed_;
  }
  /// The newest socket; waits until `count` are open.
  web::ConnectionId last(std::size_t count = 1) const {
    eventually([&] { return open().size() >= count; });
    const std::lock_guard lock(mutex_);
    return last_;
  }

 private:
  mutable std::mutex mutex_;
  std::map<web::ConnectionId, web::Opening> open_;
  std::vector<std::string> heard_;
  web::ConnectionId last_ = 0;
  int closed_ = 0;
};

/// On any free port, with both subprotocols.
struct RunningServer {
  explicit RunningServer(web::ServerOptions options = {}, web::Site site = {})
      : server(with_any_port(std::move(options)), std::move(site),
               {"foxglove.sdk.v1", "foxglove.websocket.v1"},
               Logger([this](LogLevel, const std::string& text) { log(text); })) {
    server.start(handler);
  }
  ~RunningServer() { server.stop(); }

  static web::ServerOptions with_any_port(web::ServerOptions options) {
    options.port = 0;
    return options;
  }
  void log(const std::string& text) {
    const std::lock_guard lock(log_mutex);
    logged += text + '\n';
  }
  std::string log_text() {
    const std::lock_guard lock(log_mutex);
    return logged;
  }

  std::mutex log_mutex;
  std::string logged;
  RecordingHandler handler;
  web::Server server;
};

}  // namespace bw::test
