// A sweep that takes its time, by a robot that drives an arc along a straight wall: every range in closed
// form.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "components/model/differential_drive.hpp"
#include "components/model/laser_sweep.hpp"

namespace bw::test {

/// The robot passes the origin of odom at the sweep's time, with `twist`; the wall is x = `wall` there. All
/// round; where a beam does not meet the wall it says nothing nearer than range_max.
struct MovingSweep {
  Twist2 twist{0.4, 1.5};
  Pose2 X_BL{0.1, -0.05, 0.3};
  double wall = 2.5;  ///< [m]
  Time time = Time::seconds(50.0);
  double period = 1.0 / 7.0;  ///< [s]
  int beams = 720;
  bool clockwise = true;  ///< in time: beams are listed counter-clockwise
  std::vector<float> ranges = {};

  Pose2 X_OB(Time at) const { return advance_exact({}, twist, (at - time).to_seconds()); }

  /// Views its ranges.
  LaserSweep scan() {
    ranges.assign(static_cast<std::size_t>(beams), std::numeric_limits<float>::infinity());
    LaserSweep sweep{.time = time,
                     .X_FL = X_BL,
                     .angle_min = -std::numbers::pi,
                     .angle_increment = 2.0 * std::numbers::pi / beams,
                     .range_min = 0.05,
                     .range_max = 8.0,
                     .ranges = ranges,
                     .time_increment = (clockwise ? -period : period) / beams};
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const double taken = sweep.time_increment * (static_cast<double>(i) - beams / 2.0);
      const Pose2 X_OL = X_OB(time + Duration::seconds(taken)) * X_BL;
      const double angle = X_OL.theta + sweep.angle_min + static_cast<double>(i) * sweep.angle_increment;
      const double range = (wall - X_OL.x) / std::cos(angle);
      if (range > 0.0 && range < sweep.range_max) ranges[i] = static_cast<float>(range);
    }
    return sweep;
  }
};

}  // namespace bw::test
