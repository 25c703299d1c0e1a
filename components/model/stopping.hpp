// Braking along the curve the robot is on: both wheels shrink by one factor, so the curvature stays. What
// safety functions reckon with and what motor control does, in rotations as well.
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

/// How fast |v| [m/s^2] and |omega| [rad/s^2] fall while a robot that moves with `twist` brakes so. Straight
/// on it is `deceleration`, of a rotation in place that of the wheels over half their separation.
inline Twist2 braking_of(const Twist2& twist, double deceleration, double separation) {
  const double fastest = std::abs(twist.v) + 0.5 * separation * std::abs(twist.omega);
  if (!(fastest > 0.0)) return {deceleration, 2.0 * deceleration / separation};
  return {deceleration * std::abs(twist.v) / fastest, deceleration * std::abs(twist.omega) / fastest};
}

/// The same while a safety function limits the robot to `wish`, of what falls: v, and the turn rate where v
/// falls too, or the robot is to rotate in place. Another rotation at the same speed is steering. Zero: it
/// does not fall.
inline Twist2 braking_towards(const Twist2& wish, const Twist2& twist, double deceleration,
                              double separation) {
  const auto falls = [](double to, double from) { return std::abs(to) < std::abs(from) || to * from < 0.0; };
  const bool slows = falls(wish.v, twist.v);
  const bool slows_rotation = falls(wish.omega, twist.omega) && (slows || wish.v == 0.0);
  const Twist2 braking =
      braking_of({slows ? twist.v : 0.0, slows_rotation ? twist.omega : 0.0}, deceleration, separation);
  return {slows ? braking.v : 0.0, slows_rotation ? braking.omega : 0.0};
}

}  // namespace bw
