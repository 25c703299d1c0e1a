// One sweep of a laser scanner as the local grid takes it, and whether it can be used.
#pragma once

#include <span>

#include "components/model/pose2.hpp"
#include "components/model/time.hpp"

namespace bw::costmap {

/// Beam i looks at angle_min + i * angle_increment in the scanner's frame L. By REP 117 +inf is no return and
/// -inf a return too near; NaN, and whatever lies outside range_min to range_max, is no reading.
struct Scan {
  Time time;
  Pose2 X_OL;  ///< scanner in odom at `time`
  double angle_min = 0.0;
  double angle_max = 0.0;         ///< of the last beam [rad]
  double angle_increment = 0.0;   ///< [rad]; of either sign
  double range_min = 0.0;         ///< [m]
  double range_max = 0.0;         ///< [m]
  std::span<const float> ranges;  ///< [m]; must live as long as the call
};

enum class ScanStatus {
  used,
  bad_geometry,  ///< angles or limits are not finite, without width, or more than a turn
  wrong_length,  ///< the beams do not fill angle_min to angle_max (one more or less is common, and accepted)
  bad_pose,      ///< X_OL is not finite, or so far away that cells cannot be counted
  not_later      ///< stamp not after that of the sweep before
};
const char* to_text(ScanStatus status);

/// Everything but the time.
ScanStatus check(const Scan& scan);

}  // namespace bw::costmap
