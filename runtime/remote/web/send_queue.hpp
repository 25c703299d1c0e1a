// What waits for one client, within bounds: a client that does not read loses older data and keeps the newest
// of each stream.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <optional>
#include <unordered_map>

#include "runtime/remote/web/connection.hpp"

namespace bw::web {

/// Frames with Rule::newest count as data, with Rule::always as control. Latched ones are one of each stream
/// and count as neither.
struct QueueLimits {
  std::size_t data_bytes = 8 << 20;
  std::size_t data_frames = 1024;
  std::size_t control_bytes = 16 << 20;  ///< one frame may have more, if no other waits
  std::size_t control_frames = 4096;
};

/// Each call costs the same however much waits (an exception: a bound that one large frame breaks lets
/// several small ones go).
class SendQueue {
 public:
  explicit SendQueue(QueueLimits limits) : limits_(limits) {}

  /// False: more control frames than the client may leave unread; nothing was added.
  [[nodiscard]] bool push(Frame frame, Keep keep);
  /// The oldest.
  std::optional<Frame> pop();
  void clear();

  std::size_t frames() const { return queue_.size(); }
  std::size_t bytes() const { return data_.bytes + control_.bytes + latched_.bytes; }
  std::uint64_t left_out() const { return left_out_; }  ///< data frames since the beginning

 private:
  struct Entry;
  using Position = std::list<Entry>::iterator;
  struct Entry {
    Frame frame;
    Keep keep;
    std::optional<std::list<Position>::iterator> superseded;  ///< its place in superseded_
  };
  struct Amount {
    std::size_t frames = 0;
    std::size_t bytes = 0;
  };
  Amount& amount_of(Keep::Rule rule);
  void supersede(Position older);
  void take_out(Position position);
  bool is_over() const;

  QueueLimits limits_;
  std::list<Entry> queue_;
  /// Data that may go, in the order in which newer ones of their streams came.
  std::list<Position> superseded_;
  std::unordered_map<std::uint64_t, Position> newest_;  ///< queued, by stream
  Amount data_, control_, latched_;
  std::uint64_t left_out_ = 0;
};

}  // namespace bw::web
