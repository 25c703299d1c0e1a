// Commands that the base can follow: reachable from the present velocity within one control period. Shared by
// every local planner.
#pragma once

#include "components/model/limits.hpp"
#include "runtime/base/pose2.hpp"

namespace bw {

/// The velocity nearest to `wanted` that keeps v and omega limits (scaled together, so that the curvature
/// stays) and, from `now`, the acceleration limits over `period` [s]. A velocity that is outside the limits
/// already is led back by the accelerations allowed.
Twist2 reachable_twist(const Twist2& wanted, const Twist2& now, const Limits& limits, double period);

/// The same with the linear jerk limited as well: the acceleration changes by at most jerk_max * `cycle` [s]
/// from `acceleration` [m/s^2], the one of the last command, and fades out towards the wanted speed. Speed
/// and acceleration limits come first.
Twist2 smooth_twist(const Twist2& wanted, const Twist2& now, double acceleration, const Limits& limits,
                    double period, double cycle);

/// reachable_twist for a motion that gets out of somebody's way: slowing down may use stop_deceleration.
Twist2 evasive_twist(const Twist2& wanted, const Twist2& now, const Limits& limits, double period);

/// Braking of a safety stop: stop_deceleration and alpha_max over `period` [s]. Zero when `now` is not
/// finite, or the others are not above zero.
Twist2 stop_twist(const Twist2& now, const Limits& limits, double period);

}  // namespace bw
