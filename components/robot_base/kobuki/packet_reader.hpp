// Kobuki's packets out of a stream of bytes (components/robot_base/kobuki/README.md):
//
//   AA 55, u8 length of payload, payload, u8 XOR of length and payload;  payload: sub-payloads u8 id, u8
//   size, data
//
// Any byte may be wrong or missing. A packet is believed if its sub-payloads fill it exactly and its checksum
// holds. While one that begins earlier is not complete, a later one that is complete and has the core sensor
// data wins, so that a false beginning in garbage swallows none: the second whole packet after garbage is
// always found.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace bw::kobuki {

struct ReaderCounts {
  std::uint64_t packets = 0;
  std::uint64_t bad_checksums = 0;      ///< of what began as a packet and had its form
  std::uint64_t bytes_thrown_away = 0;  ///< in no packet
};

class PacketReader {
 public:
  void add(std::span<const std::uint8_t> bytes);
  /// The payload of the next packet, valid until the next call of anything; empty: there is none yet.
  std::span<const std::uint8_t> next();
  /// Forgets what is half there: the cable was opened anew.
  void reset();
  const ReaderCounts& counts() const { return counts_; }

 private:
  void drop(std::size_t bytes);

  std::vector<std::uint8_t> bytes_;
  std::size_t taken_ = 0;  ///< of `bytes_`, already handed out or thrown away
  ReaderCounts counts_;
};

}  // namespace bw::kobuki
