// What the connections of a server share. With Boost: for the sources of this folder alone.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include <boost/asio/io_context.hpp>

#include "runtime/logger.hpp"
#include "runtime/remote/web/connection.hpp"
#include "runtime/remote/web/router.hpp"

namespace bw::web {

class HttpSession;
class SocketSession;

/// Of a steady clock [s].
inline double now_in_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

inline std::chrono::nanoseconds to_chrono(double seconds) {
  return std::chrono::nanoseconds(static_cast<std::int64_t>(seconds * 1e9));
}

/// Used on the server's thread, but for find().
class Core {
 public:
  Core(const ServerOptions& options, bool is_loopback, Site site, std::vector<std::string> subprotocols,
       Logger log)
      : limits(options.limits),
        router(options, is_loopback, std::move(site), std::move(subprotocols)),
        logger(std::move(log)) {}

  std::shared_ptr<SocketSession> find(ConnectionId id) const;
  void add(ConnectionId id, std::shared_ptr<SocketSession> session);
  void remove(ConnectionId id);
  std::vector<std::shared_ptr<SocketSession>> all() const;

  const Limits limits;
  Router router;
  const Logger logger;
  SocketHandler* handler = nullptr;
  bool is_stopping = false;
  ConnectionId last_id = 0;
  int connections = 0;                       ///< open, HTTP and sockets
  int sockets = 0;                           ///< open or being opened
  std::unordered_set<HttpSession*> waiting;  ///< HTTP connections, to be closed when the server stops

 private:
  mutable std::mutex mutex_;
  std::unordered_map<ConnectionId, std::shared_ptr<SocketSession>> sessions_;

 public:
  /// Goes first: connections that still wait for something go with it, and count down above.
  boost::asio::io_context io{1};
};

/// One more of `count` as long as it lives.
class Counted {
 public:
  explicit Counted(int& count) : count_(&count) { ++count; }
  ~Counted() {
    if (count_ != nullptr) --*count_;
  }
  Counted(Counted&& other) noexcept : count_(std::exchange(other.count_, nullptr)) {}
  Counted& operator=(Counted&&) = delete;

 private:
  int* count_;
};

}  // namespace bw::web
