#include "components/local_planner/command_limits.hpp"

#include <algorithm>
#include <cmath>

namespace bw {
namespace {

double step_towards(double wanted, double now, double largest_change) {
  return std::clamp(wanted, now - largest_change, now + largest_change);
}

// Scaled as a whole, so that the curvature stays.
Twist2 within_limits(const Twist2& wanted, const Limits& limits) {
  double scale = 1.0;
  const double v_limit = wanted.v >= 0.0 ? limits.v_max : limits.v_back_max;
  if (std::abs(wanted.v) > v_limit) scale = v_limit / std::abs(wanted.v);
  if (std::abs(wanted.omega) * scale > limits.omega_max) scale = limits.omega_max / std::abs(wanted.omega);
  return {scale * wanted.v, scale * wanted.omega};
}

}  // namespace

Twist2 reachable_twist(const Twist2& wanted, const Twist2& now, const Limits& limits, double period) {
  const Twist2 inside = within_limits(wanted, limits);
  return {step_towards(inside.v, now.v, limits.acc_max * period),
          step_towards(inside.omega, now.omega, limits.alpha_max * period)};
}

Twist2 smooth_twist(const Twist2& wanted, const Twist2& now, double acceleration, const Limits& limits,
                    double period, double cycle) {
  Twist2 command = reachable_twist(wanted, now, limits, period);
  const double change = command.v - now.v;
  const double fading = std::sqrt(2.0 * limits.jerk_max * std::abs(change));
  const double wanted_acceleration = std::copysign(std::min(std::abs(change) / period, fading), change);
  const double step = limits.jerk_max * cycle;
  const double smooth = std::clamp(std::clamp(wanted_acceleration, acceleration - step, acceleration + step),
                                   -limits.acc_max, limits.acc_max);
  // From outside the speed limits no jump to them.
  command.v =
      std::clamp(now.v + smooth * period, std::min(-limits.v_back_max, now.v), std::max(limits.v_max, now.v));
  return command;
}

Twist2 evasive_twist(const Twist2& wanted, const Twist2& now, const Limits& limits, double period) {
  const Twist2 inside = within_limits(wanted, limits);
  const bool slowing = inside.v * now.v >= 0.0 && std::abs(inside.v) < std::abs(now.v);
  const double acceleration = slowing ? limits.stop_deceleration : limits.acc_max;
  return {step_towards(inside.v, now.v, acceleration * period),
          step_towards(inside.omega, now.omega, limits.alpha_max * period)};
}

Twist2 stop_twist(const Twist2& now, const Limits& limits, double period) {
  if (!is_finite(now) || !(limits.stop_deceleration > 0.0) || !(limits.alpha_max > 0.0) || !(period > 0.0))
    return {};
  return {step_towards(0.0, now.v, limits.stop_deceleration * period),
          step_towards(0.0, now.omega, limits.alpha_max * period)};
}

}  // namespace bw
