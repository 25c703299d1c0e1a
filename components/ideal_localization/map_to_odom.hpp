// Where odom must lie in map so that the odometry's pose falls on the true one: X_MO = X_MB X_OB^-1, both at
// the same instant.
#pragma once

#include "components/model/differential_drive.hpp"

namespace bw {

/// True pose and twist at one instant, odometry `ahead` seconds later (or earlier): the truth is carried over
/// along its arc.
inline Pose2 map_to_odom(const Pose2& X_MB, const Twist2& twist, double ahead, const Pose2& X_OB) {
  return advance_exact(X_MB, twist, ahead) * inverse(X_OB);
}

}  // namespace bw
