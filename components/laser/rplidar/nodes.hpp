// The stream of the standard scan: five bytes for each measurement, without a checksum.
//
//   byte 0     bit 0 a revolution begins, bit 1 its opposite, bits 2..7 quality
//   bytes 1-2  bit 0 is 1, bits 1..15 angle * 64 [degrees], clockwise as seen from above
//   bytes 3-4  distance * 4 [mm]; 0: nothing measured
//
// Three bits a node are all that the format gives for keeping in step. What else is known is that the head
// rotates steadily: a node whose angle does not follow the one before is a sign of lost bytes, too. At a
// wrong place a node has both by chance, one in a hundred, and more in a row where a wall keeps its range: so
// a reader that lost step looks for it from some nodes before the position on, and reads again what it had
// read wrongly. What it gave out until then it cannot take back.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "components/laser/rplidar/protocol.hpp"

namespace bw::laser {

struct Node {
  bool starts_revolution = false;
  std::uint8_t quality = 0;    ///< 0 to 63
  std::uint16_t angle_q6 = 0;  ///< [1/64 degree], clockwise, below 360 degrees and a little
  std::uint16_t range_q2 = 0;  ///< [mm / 4]; 0: nothing measured

  double angle() const;                                                    ///< clockwise [rad]
  float range() const { return static_cast<float>(range_q2) * 0.00025F; }  ///< [m]
  bool operator==(const Node&) const = default;
};

/// Nothing when the three bits, or the angle, are not those of a node.
std::optional<Node> read_node(std::span<const std::uint8_t, kNodeSize> bytes);

struct NodeCounters {
  std::uint64_t nodes = 0;
  std::uint64_t losses_of_step = 0;
  std::uint64_t bytes_thrown_away = 0;
};

class NodeReader {
 public:
  /// A stream begins: its first byte is the first of a node.
  void begin();
  /// Appends what is whole to `nodes`.
  void read(std::span<const std::uint8_t> bytes, std::vector<Node>& nodes);
  const NodeCounters& counters() const { return counters_; }

 private:
  enum class Row : std::uint8_t { fits, breaks, goes_on };

  /// False when more bytes are needed.
  bool take_one(std::vector<Node>& nodes);
  bool find_step();
  Row row_at(std::size_t at) const;
  void forget();

  std::vector<std::uint8_t> bytes_;  ///< of the nodes read last, and what waits
  std::size_t next_ = 0;             ///< what waits begins here; not in step: nothing before it fitted
  std::size_t candidate_ = 0;        ///< not in step: nothing before it can be where step is found again
  bool in_step_ = false;
  std::optional<Node> last_;
  NodeCounters counters_;
};

}  // namespace bw::laser
