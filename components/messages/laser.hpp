// From sensor_msgs/LaserScan to a sweep. For adaptors only.
#pragma once

#include <cmath>

#include <sensor_msgs/msg/laser_scan.hpp>

#include "components/model/laser_sweep.hpp"
#include "runtime/stamps.hpp"

namespace bw {

/// When the beam in the middle was taken. A head that turns takes its beams one after the other, from the stamp on (backwards, if the
/// increment is negative): who takes them all for one instant errs least with this one.
inline Time time_of(const sensor_msgs::msg::LaserScan& message) {
  const Time first = from_stamp(message.header().stamp());
  const double half =
      0.5 * static_cast<double>(message.time_increment()) * static_cast<double>(message.ranges().size());
  constexpr double kLongest = 0.5;  // [s]: half of a turn that any laser needs
  return first > Time{} && std::abs(half) <= kLongest ? first + Duration::seconds(half) : first;
}

/// Looks into the message, which must live as long. X_FL: the scanner in the frame the reader works in.
inline LaserSweep to_sweep(const sensor_msgs::msg::LaserScan& message, const Pose2& X_FL) {
  return {.time = time_of(message),
          .X_FL = X_FL,
          .angle_min = message.angle_min(),
          .angle_increment = message.angle_increment(),
          .range_min = message.range_min(),
          .range_max = message.range_max(),
          .ranges = message.ranges(),
          .angle_max = message.angle_max()};
}

}  // namespace bw
