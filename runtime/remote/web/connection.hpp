// What the server of web pages and sockets (server.hpp) and whoever speaks over its sockets say to each
// other. No Boost here.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bw::web {

using ConnectionId = std::uint64_t;  ///< of one socket; never used twice in a run
using Bytes = std::vector<std::uint8_t>;
using SharedBytes = std::shared_ptr<const Bytes>;

/// The few bytes before a shared body that differ from client to client; at most 24.
class Head {
 public:
  Head() = default;
  explicit Head(std::span<const std::uint8_t> bytes)
      : size_(static_cast<std::uint8_t>(std::min(bytes.size(), bytes_.size()))) {
    std::copy_n(bytes.begin(), size_, bytes_.begin());
  }
  std::span<const std::uint8_t> bytes() const { return {bytes_.data(), size_}; }

 private:
  std::array<std::uint8_t, 24> bytes_ = {};
  std::uint8_t size_ = 0;
};

/// One WebSocket message: its head and then its body, written as one without putting them together. The body
/// is shared by all who get it.
struct Frame {
  bool is_text = false;  ///< then it is UTF-8
  Head head = {};
  SharedBytes body = {};  ///< null: empty

  std::size_t size() const { return head.bytes().size() + (body ? body->size() : 0); }
};

inline Frame text_frame(std::string_view text) {
  return {.is_text = true, .body = std::make_shared<const Bytes>(text.begin(), text.end())};
}
inline Frame binary_frame(Bytes bytes) { return {.body = std::make_shared<const Bytes>(std::move(bytes))}; }

/// Which frames of a slow client may be left out. Frames of one client are sent in the order in which they
/// were given.
struct Keep {
  enum class Rule : std::uint8_t {
    always,  ///< answers and announcements; too many of them close the connection
    newest,  ///< data of `stream`: where the queue is full, older frames of the streams go, the newest of each stays
    latched,  ///< stays as well; of one `stream` only the newest, so each writer of a latched topic is a stream
  };
  Rule rule = Rule::always;
  std::uint64_t stream =
      0;  ///< of the client, chosen by the handler; `newest` and `latched` share the numbers
};

/// Of a socket that has been let in.
struct Opening {
  std::string subprotocol;  ///< the one that was agreed on
  std::string peer;         ///< address:port
  std::string origin;       ///< empty: a program, no page
  std::string read_only;    ///< why it may not command (gate.hpp); empty: it may
};

/// Whoever speaks over the sockets. All calls come on the server's thread, and none of them from within a
/// call of SocketSender.
class SocketHandler {
 public:
  virtual ~SocketHandler() = default;
  virtual void on_open(ConnectionId id, const Opening& opening) = 0;
  virtual void on_text(ConnectionId id, std::string_view text) = 0;
  virtual void on_binary(ConnectionId id, std::span<const std::uint8_t> bytes) = 0;
  /// Once for each on_open, at the latest when the server stops.
  virtual void on_close(ConnectionId id) = 0;
};

/// The server as the handler sees it. From any thread.
class SocketSender {
 public:
  virtual ~SocketSender() = default;
  /// Costs the same however long the queue is, and never waits for the client. Nothing happens where the
  /// connection is gone.
  virtual void send(ConnectionId id, Frame frame, Keep keep) = 0;
  /// What is queued is still sent, if the client takes it in time. WebSocket's close codes; `reason` of at
  /// most 123 bytes. Nothing that the client says afterwards is handed on.
  virtual void close(ConnectionId id, std::uint16_t code, const std::string& reason) = 0;
};

/// The server's thread. From any thread; what is left when the server stops is not called.
class Loop {
 public:
  virtual ~Loop() = default;
  virtual void post(std::function<void()> call) = 0;
  virtual void after(std::chrono::milliseconds delay, std::function<void()> call) = 0;
};

}  // namespace bw::web
