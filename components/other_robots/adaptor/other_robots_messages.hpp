// What other robots and the laser say, as values. Pure conversions.
#pragma once

#include <cstddef>
#include <vector>

#include <nav_msgs/msg/odometry.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>

#include "components/messages/geometry.hpp"
#include "components/messages/laser.hpp"
#include "components/other_robots/robot_tracks.hpp"

namespace bw {

inline RobotReport report_of(const nav_msgs::msg::Odometry& message) {
  return {.time = from_stamp(message.header().stamp()),
          .X_MR = from_pose(message.pose().pose()),
          .twist = from_twist(message.twist().twist()),
          .covariance = planar_covariance(message.pose().covariance()).topLeftCorner<2, 2>()};
}

/// Where the beams of a sound sweep ended, in the frame that X_FL is seen from; nothing of another.
inline std::vector<Vector2> hits_of(const sensor_msgs::msg::LaserScan& message, const Pose2& X_FL) {
  const LaserSweep sweep = to_sweep(message, X_FL);
  std::vector<Vector2> hits;
  if (fault_of(sweep) != SweepFault::none) return hits;
  for (std::size_t i = 0; i < sweep.ranges.size(); ++i) {
    if (kind_of(sweep.ranges[i], sweep) != BeamKind::hit) continue;
    const double angle = sweep.angle_min + static_cast<double>(i) * sweep.angle_increment;
    hits.push_back(X_FL * Vector2(direction(angle) * static_cast<double>(sweep.ranges[i])));
  }
  return hits;
}

}  // namespace bw
