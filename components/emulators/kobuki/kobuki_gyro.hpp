// The gyro of a Kobuki: raw samples of three axes with bias, noise and steps of 0.00875 deg/s, and the angle
// that the board makes of its calibrated rate. The chip is mounted rotated by 90 degrees: raw x is the
// robot's y, raw y its -x, raw z its z.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "components/emulators/kobuki/kobuki_options.hpp"
#include "components/model/random.hpp"

namespace bw::emulators {

/// x, y, z as the chip counts.
using RawGyroSample = std::array<int, 3>;

class KobukiGyro {
 public:
  KobukiGyro(const KobukiGyroOptions& options, std::uint64_t seed);

  /// Rotates at `rate` [rad/s] about z for dt [s].
  void step(double rate, double dt);
  /// Those since the last call, at most 3, oldest first; older ones are lost, as they are for the board.
  std::vector<RawGyroSample> take_samples();
  /// Counts all samples ever made; of the last one.
  std::uint8_t frame_id() const { return frame_id_; }
  int angle_in_hundredths() const;  ///< [0.01 deg], -18000 to 18000
  int rate_in_hundredths() const;   ///< [0.01 deg/s]

 private:
  KobukiGyroOptions options_;
  Random random_;
  double to_next_sample_;
  double angle_ = 0.0;  ///< [deg]
  double rate_ = 0.0;   ///< [deg/s]
  std::vector<RawGyroSample> samples_;
  std::uint8_t frame_id_ = 0;
};

}  // namespace bw::emulators
