// Finds answers among the bytes of a device: a header, then its data; a header of the scan begins the stream
// of nodes, which ends only by restart().
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "components/laser/rplidar/nodes.hpp"
#include "components/laser/rplidar/protocol.hpp"

namespace bw::laser {

/// What a piece of the bytes held, in its order: answers come before the nodes of a stream.
struct Received {
  std::optional<Info> info;
  std::optional<Health> health;
  std::optional<Duration> sample_time;
  bool scan_begins = false;
  std::vector<Node> nodes;
};

class AnswerReader {
 public:
  /// What waits is forgotten; headers are looked for.
  void restart();
  /// Valid until the next call.
  const Received& read(std::span<const std::uint8_t> bytes);

  bool is_streaming() const { return is_streaming_; }
  const NodeCounters& nodes() const { return nodes_.counters(); }
  /// That were part of no answer, outside of streams.
  std::uint64_t bytes_thrown_away() const { return bytes_thrown_away_; }

 private:
  bool take_one();
  void take_in(AnswerType type, std::span<const std::uint8_t> data);

  std::vector<std::uint8_t> waiting_;
  std::size_t taken_ = 0;
  bool is_streaming_ = false;
  NodeReader nodes_;
  std::uint64_t bytes_thrown_away_ = 0;
  Received received_;
};

}  // namespace bw::laser
