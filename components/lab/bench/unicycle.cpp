#include "components/lab/bench/unicycle.hpp"

#include <algorithm>
#include <cmath>

#include "components/model/nearest_point.hpp"

namespace bw {

TwistChange twice_the_limits(const Limits& limits, double period) {
  const double dv = 2.0 * limits.acc_max * period;
  return {dv, dv, 2.0 * limits.alpha_max * period};
}

Twist2 applied_twist(const Twist2& command, const Twist2& last, const Limits& limits,
                     const TwistChange& change) {
  const double v = std::clamp(command.v, -limits.v_back_max, limits.v_max);
  const double omega = std::clamp(command.omega, -limits.omega_max, limits.omega_max);
  return {std::clamp(v, last.v - change.fall, last.v + change.rise),
          std::clamp(omega, last.omega - change.turn, last.omega + change.turn)};
}

Pose2 unicycle_step(const Pose2& pose, const Twist2& twist, double h) {
  const double heading = pose.theta + twist.omega * h / 2.0;
  return {pose.x + twist.v * h * std::cos(heading), pose.y + twist.v * h * std::sin(heading),
          wrap_angle(pose.theta + twist.omega * h)};
}

double closest_approach(const Vector2& offset, const Vector2& velocity, double duration) {
  return nearest_point(Segment{offset, offset + duration * velocity}, Vector2(0.0, 0.0)).norm();
}

double rms_jerk(const std::vector<double>& accelerations, double period) {
  if (accelerations.size() < 2) return 0.0;
  double squares = 0.0;
  for (std::size_t i = 1; i < accelerations.size(); ++i) {
    const double jerk = (accelerations[i] - accelerations[i - 1]) / period;
    squares += jerk * jerk;
  }
  return std::sqrt(squares / static_cast<double>(accelerations.size() - 1));
}

}  // namespace bw
