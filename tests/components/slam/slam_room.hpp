// A room, and a robot that goes round in it, with odometry that is 3 % short and turns too far.
#pragma once

#include <algorithm>
#include <limits>
#include <numbers>
#include <vector>

#include <sensor_msgs/msg/laser_scan.hpp>

#include "components/messages/geometry.hpp"
#include "components/model/differential_drive.hpp"
#include "components/model/obstacles.hpp"
#include "components/world/ray.hpp"

namespace bw::slam::test {

/// 8 m by 6 m, with a cupboard that tells its sides apart. The robot starts at the origin.
inline const std::vector<Segment> kRoom = {{{-4.0, -1.5}, {4.0, -1.5}}, {{4.0, -1.5}, {4.0, 4.5}},
                                           {{4.0, 4.5}, {-4.0, 4.5}},   {{-4.0, 4.5}, {-4.0, -1.5}},
                                           {{-4.0, 3.5}, {-2.0, 3.5}},  {{-2.0, 3.5}, {-2.0, 4.5}},
                                           {{2.6, -1.5}, {2.6, -1.0}},  {{2.6, -1.0}, {4.0, -1.0}}};
inline constexpr double kSpeed = 0.5;
inline constexpr double kRadius = 1.5;
inline constexpr Pose2 kMount{0.15, 0.0, std::numbers::pi};  // a scanner that looks back

inline Pose2 truth_at(double t) { return advance_exact({}, {kSpeed, kSpeed / kRadius}, t); }
inline Pose2 odometry_at(double t) { return advance_exact({}, {0.97 * kSpeed, 1.02 * kSpeed / kRadius}, t); }

/// Who stands in the room for all the time, if anybody does.
inline const Disc kPerson{{-2.5, 1.0}, 0.25};

/// What a scanner at kMount measures, without noise.
inline sensor_msgs::msg::LaserScan room_scan(const Pose2& X_MB, Time stamp, bool person) {
  sensor_msgs::msg::LaserScan scan;
  scan.header(make_header("laser", stamp));
  scan.angle_min(-static_cast<float>(std::numbers::pi));
  scan.angle_increment(static_cast<float>(2.0 * std::numbers::pi / 360.0));
  scan.angle_max(scan.angle_min() + 359.0F * scan.angle_increment());
  scan.range_min(0.05F);
  scan.range_max(12.0F);
  const Pose2 X_ML = X_MB * kMount;
  for (int i = 0; i < 360; ++i) {
    const double angle =
        static_cast<double>(scan.angle_min()) + i * static_cast<double>(scan.angle_increment());
    double range = std::numeric_limits<double>::infinity();
    for (const Segment& wall : kRoom)
      range = std::min(range, ray_hit(X_ML.position(), direction(X_ML.theta + angle), wall));
    if (person) range = std::min(range, ray_hit(X_ML.position(), direction(X_ML.theta + angle), kPerson));
    scan.ranges().push_back(static_cast<float>(range));
  }
  return scan;
}

}  // namespace bw::slam::test
