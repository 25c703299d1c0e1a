// The velocities DWA chooses from: V_s, what the robot may do, cut with V_d, what it can reach (theory.md
// 5.2).
#pragma once

#include <vector>

#include "components/model/limits.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::dwa {

struct Interval {
  double low = 0.0;
  double high = 0.0;
  bool operator==(const Interval&) const = default;
};

struct VelocityWindow {
  Interval v;      ///< [m/s]
  Interval omega;  ///< [rad/s]
};

/// [0, v_cap] x [-omega_max, omega_max], as far as the accelerations lead from `now` within `time` [s]. Where
/// they lead to none of it: the reachable velocity nearest to it. Forward only.
VelocityWindow velocity_window(const Twist2& now, const Limits& limits, double v_cap, double time);

/// `v_count` x `omega_count` velocities over the window, edges included; rows and columns for the present
/// velocity, for standing and for driving straight are added where the window holds them.
std::vector<Twist2> velocity_samples(const VelocityWindow& window, const Twist2& now, int v_count,
                                     int omega_count);

}  // namespace bw::dwa
