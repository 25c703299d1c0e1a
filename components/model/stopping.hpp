// Braking along the curve the robot is on: both wheels shrink by one factor, so the curvature stays.
#pragma once

#include <algorithm>
#include <cmath>

#include "components/model/differential_drive.hpp"

namespace bw {

/// Wheel speeds [m/s] after braking for `dt` [s]: the faster wheel loses `deceleration` * dt [m/s], the other
/// its share.
inline WheelSpeeds brake(const WheelSpeeds& wheels, double deceleration, double dt) {
  const double fastest = std::max(std::abs(wheels.left), std::abs(wheels.right));
  const double left_over = fastest - deceleration * dt;
  if (!(left_over > 0.0)) return {};
  return {wheels.left * (left_over / fastest), wheels.right * (left_over / fastest)};
}

}  // namespace bw
