// What robot_base asks of a base: take wheel speeds, give encoder counts. A simulated world, a Kobuki and an
// Eddie are all one of these.
#pragma once

#include <functional>

#include "components/model/differential_drive.hpp"
#include "components/robot_base/encoder_odometry.hpp"

namespace bw {

class Driver {
 public:
  using OnCounts = std::function<void(const EncoderCounts&)>;

  virtual ~Driver() = default;
  /// Turns the wheels at these ground speeds [m/s] from `now` on.
  virtual void command(Time now, const WheelSpeeds& wheels) = 0;
  /// Every reading of the encoders goes to `sink`, in the order of its stamps.
  virtual void deliver_counts_to(OnCounts sink) = 0;
};

}  // namespace bw
