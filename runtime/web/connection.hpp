// What the server of web pages and sockets (server.hpp) and whoever speaks over its sockets say to each other. No Boost here.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bw::web {

using ConnectionId = std::uint64_t;  ///< of one socket; never used twice in a run

/// One WebSocket message, shared by all who get it.
struct Frame {
  bool is_text = false;
  std::vector<std::uint8_t> bytes;
};
using FramePtr = std::shared_ptr<const Frame>;

/// Which frames of a slow client may be left out. Frames of one client are sent in the order in which they were given.
struct Keep {
  enum class Rule : std::uint8_t {
    always,  ///< answers and announcements; too many of them close the connection
    newest,  ///< data of `stream`: where the queue is full, older frames of the streams go, the newest of each stays
    latched,  ///< as `always`, but a newer frame of the same `stream` that is queued takes its place
  };
  Rule rule = Rule::always;
  std::uint64_t stream = 0;
};

/// Of a socket that has been let in.
struct Opening {
  std::string subprotocol;  ///< the one that was agreed on
  std::string peer;         ///< address:port
  std::string origin;       ///< empty: a program, no page
  bool may_command = true;  ///< what the access rules allow it (access.hpp)
};

/// Whoever speaks over the sockets. All calls come on the server's thread.
class SocketHandler {
 public:
  virtual ~SocketHandler() = default;
  virtual void on_open(ConnectionId id, const Opening& opening) = 0;
  virtual void on_text(ConnectionId id, std::string_view text) = 0;
  virtual void on_binary(ConnectionId id, const std::vector<std::uint8_t>& bytes) = 0;
  virtual void on_close(ConnectionId id) = 0;
};

/// The server as the handler sees it. From any thread.
class SocketSender {
 public:
  virtual ~SocketSender() = default;
  /// Nothing happens where the connection is gone.
  virtual void send(ConnectionId id, FramePtr frame, Keep keep) = 0;
  /// WebSocket's close codes; `reason` of at most 123 bytes.
  virtual void close(ConnectionId id, std::uint16_t code, const std::string& reason) = 0;
};

}  // namespace bw::web
