// From sensor_msgs/LaserScan to a sweep. For adaptors only.
#pragma once

#include <cmath>

#include <sensor_msgs/msg/laser_scan.hpp>

#include "components/model/laser_sweep.hpp"
#include "runtime/stamps.hpp"

namespace bw {

/// From one beam to the next [s]: a head that rotates takes them one after the other, from the stamp on
/// (backwards, if negative). Zero: all at the stamp, as of who says nothing, or what no laser does.
inline double time_increment_of(const sensor_msgs::msg::LaserScan& message) {
  constexpr double kLongest = 1.0;  // [s]: a revolution that any laser needs
  const auto increment = static_cast<double>(message.time_increment());
  const bool is_sound = std::abs(increment) * static_cast<double>(message.ranges().size()) <= kLongest;
  return is_sound && from_stamp(message.header().stamp()) > Time{} ? increment : 0.0;
}

/// When the beam in the middle was taken: who takes all beams for one instant errs least with this one.
inline Time time_of(const sensor_msgs::msg::LaserScan& message) {
  const double half = 0.5 * time_increment_of(message) * static_cast<double>(message.ranges().size());
  return from_stamp(message.header().stamp()) + Duration::seconds(half);
}

/// Looks into the message, which must live as long. X_FL: the scanner in the frame the reader works in, at
/// time_of(message). sweep_motion.hpp has where it was at the other beams.
inline LaserSweep to_sweep(const sensor_msgs::msg::LaserScan& message, const Pose2& X_FL) {
  return {.time = time_of(message),
          .X_FL = X_FL,
          .angle_min = message.angle_min(),
          .angle_increment = message.angle_increment(),
          .range_min = message.range_min(),
          .range_max = message.range_max(),
          .ranges = message.ranges(),
          .angle_max = message.angle_max(),
          .time_increment = time_increment_of(message)};
}

}  // namespace bw
