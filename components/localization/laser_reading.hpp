// One sweep of a laser scanner. Not part of Measurement: it is a view of somebody else's beams, too large to
// keep.
#pragma once

#include <span>

#include "components/model/pose2.hpp"
#include "components/model/time.hpp"

namespace bw::localization {

/// Beam i looks at angle_min + i * angle_increment in the scanner's frame L. By REP 117 +inf is no return and
/// -inf a return too near; NaN is no reading.
struct LaserReading {
  Time time;
  int source = 0;
  double angle_min = 0.0;         ///< [rad]
  double angle_increment = 0.0;   ///< [rad]
  double range_min = 0.0;         ///< nearer is no reading [m]
  double range_max = 0.0;         ///< farther is no return [m]
  Pose2 X_BL;                     ///< scanner in base_link
  std::span<const float> ranges;  ///< [m]; must live as long as the call
};

}  // namespace bw::localization
