// From sensor_msgs/LaserScan to a sweep. For adaptors only.
#pragma once

#include <sensor_msgs/msg/laser_scan.hpp>

#include "components/model/laser_sweep.hpp"
#include "runtime/stamps.hpp"

namespace bw {

/// Looks into the message, which must live as long. X_FL: the scanner in the frame the reader works in.
inline LaserSweep to_sweep(const sensor_msgs::msg::LaserScan& message, const Pose2& X_FL) {
  return {.time = from_stamp(message.header().stamp()),
          .X_FL = X_FL,
          .angle_min = message.angle_min(),
          .angle_increment = message.angle_increment(),
          .range_min = message.range_min(),
          .range_max = message.range_max(),
          .ranges = message.ranges(),
          .angle_max = message.angle_max()};
}

}  // namespace bw
