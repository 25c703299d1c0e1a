// The ideal base of the closed-loop benches: a unicycle that drives a command within its limits. Metres,
// seconds, radians.
#pragma once

#include <vector>

#include "components/model/limits.hpp"
#include "runtime/base/pose2.hpp"

namespace bw {

/// By how much a command differs from the last one at most.
struct TwistChange {
  double rise = 0.0;  ///< of v [m/s]
  double fall = 0.0;
  double turn = 0.0;  ///< of omega [rad/s]
};

/// Twice what the limits are in `period` [s].
TwistChange twice_the_limits(const Limits& limits, double period);

/// `command` within the limits, and within `change` of `last`.
Twist2 applied_twist(const Twist2& command, const Twist2& last, const Limits& limits,
                     const TwistChange& change);

/// After `h` [s] of `twist`, by (1.1).
Pose2 unicycle_step(const Pose2& pose, const Twist2& twist, double h);

/// The least distance [m] between two points within `duration` [s], one seen from the other at `offset`,
/// moving at `velocity`.
double closest_approach(const Vector2& offset, const Vector2& velocity, double duration);

/// Root mean square of the differences of accelerations [m/s^2], `period` [s] apart; 0 when there are not
/// two.
double rms_jerk(const std::vector<double>& accelerations, double period);

}  // namespace bw
