// What a calibration knows of one motion: how far the wheels rotated on the way, and where the robot stood at
// its end.
#pragma once

#include <vector>

#include "components/model/robot.hpp"
#include "runtime/base/pose2.hpp"

namespace bw {

/// What UMBmark measures of a differential drive, and its scale.
struct WheelGeometry {
  double radius = 0.0;      ///< mean of both wheels [m]
  double ratio = 1.0;       ///< radius of the right wheel over that of the left one: E_d
  double separation = 0.0;  ///< [m]; over the nominal one: E_b
};

inline WheelGeometry geometry_of(const Robot& robot) {
  return {robot.wheel_radius, robot.wheel_radius_ratio, robot.wheel_separation};
}

/// Rotations of both wheels since the sample before [rad].
struct WheelRotations {
  double left = 0.0;
  double right = 0.0;
};

struct MeasuredMotion {
  enum class Known { distance, position, pose };  ///< of `moved`

  std::vector<WheelRotations> rotations;
  Pose2 moved;  ///< where it ended, in the frame of where it began, heading along x; `distance`: x alone
  Known known = Known::pose;
};

/// Where wheels of that geometry end.
Pose2 rolled(const std::vector<WheelRotations>& rotations, const WheelGeometry& geometry);

}  // namespace bw
