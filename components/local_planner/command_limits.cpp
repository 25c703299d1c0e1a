#include "components/local_planner/command_limits.hpp"

#include <algorithm>
#include <cmath>

namespace bw {
namespace {

double step_towards(double wanted, double now, double largest_change) {
  return std::clamp(wanted, now - largest_change, now + largest_change);
}

}  // namespace

Twist2 reachable_twist(const Twist2& wanted, const Twist2& now, const Limits& limits, double period) {
  double scale = 1.0;
  const double v_limit = wanted.v >= 0.0 ? limits.v_max : limits.v_back_max;
  if (std::abs(wanted.v) > v_limit) scale = v_limit / std::abs(wanted.v);
  if (std::abs(wanted.omega) * scale > limits.omega_max) scale = limits.omega_max / std::abs(wanted.omega);
  return {step_towards(scale * wanted.v, now.v, limits.acc_max * period),
          step_towards(scale * wanted.omega, now.omega, limits.alpha_max * period)};
}

Twist2 stop_twist(const Twist2& now, const Limits& limits, double period) {
  if (!is_finite(now) || !(limits.stop_deceleration > 0.0) || !(limits.alpha_max > 0.0) || !(period > 0.0))
    return {};
  return {step_towards(0.0, now.v, limits.stop_deceleration * period),
          step_towards(0.0, now.omega, limits.alpha_max * period)};
}

}  // namespace bw
