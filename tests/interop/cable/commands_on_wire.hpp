// What a host tells a base, read off the wire by the protocols alone: nothing of the drivers is used.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/interop/cable/cable_between.hpp"

namespace bw::test {

/// A frame that tells the wheels what to do.
struct WireCommand {
  std::chrono::steady_clock::time_point time;
  std::uint64_t plugging = 0;
  int speed =
      0;  ///< in the units of the base: mm/s, or positions per unit of time of the faster wheel; 0 is a stop
};

/// Reads chunks as they come; a frame may lie in several.
class WireReader {
 public:
  virtual ~WireReader() = default;
  std::vector<WireCommand> read(const std::vector<Chunk>& chunks);

 protected:
  /// Takes a frame off the front of `bytes_`: false when there is no whole one.
  virtual bool take_frame(bool& is_command, int& speed) = 0;

  std::string bytes_;

 private:
  std::uint64_t plugging_ = 0;
};

/// AA 55 LENGTH PAYLOAD XOR; the sub-payload 01 04 has speed [mm/s] and radius, two bytes each, low one
/// first.
class KobukiWire final : public WireReader {
  bool take_frame(bool& is_command, int& speed) override;
};

/// Lines that end with CR: GOSPD LEFT RIGHT in hexadecimal, STOP.
class EddieWire final : public WireReader {
  bool take_frame(bool& is_command, int& speed) override;
};

}  // namespace bw::test
