// Nodes of a rotating head put together to revolutions, in the laser's frame L: x where the device has its 0
// degrees, z up, angles counter-clockwise. A revolution goes from the rear (180 degrees) to the rear: where
// its two ends, a whole revolution of time apart, do not fit together, that is behind the robot and not ahead
// of it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "components/laser/rplidar/nodes.hpp"
#include "runtime/base/time.hpp"

namespace bw::laser {

struct Sample {
  double angle = 0.0;  ///< in L, counter-clockwise, in [-pi, pi) [rad]
  float range = 0.0F;  ///< [m]; 0: nothing measured
  std::uint8_t quality = 0;
};

struct Revolution {
  Time first;                   ///< when the first sample was taken
  Time next;                    ///< when the first one of the next revolution was: first + the period
  bool is_clockwise = true;     ///< as the samples follow each other in time, seen from above
  std::vector<Sample> samples;  ///< in the order of time
};

class RevolutionCollector {
 public:
  /// `is_upside_down`: mounted head first, so that the device's clockwise is counter-clockwise from above.
  explicit RevolutionCollector(bool is_upside_down) : is_upside_down_(is_upside_down) {}

  /// The revolution that `node`, taken at `time`, follows on. The first one is not told: it was not seen from
  /// its beginning.
  std::optional<Revolution> add(const Node& node, Time time);
  /// Nodes were missed for an unknown time.
  void restart();
  /// Beginnings that the device itself told, for diagnostics.
  std::uint64_t start_bits() const { return start_bits_; }

 private:
  bool is_upside_down_;
  bool is_whole_ = false;  ///< what is collected began at the rear
  double revolved_ = 0.0;  ///< since it began [rad], clockwise from the device's side
  std::optional<double> last_angle_;
  Revolution collected_;
  std::uint64_t start_bits_ = 0;
};

}  // namespace bw::laser
