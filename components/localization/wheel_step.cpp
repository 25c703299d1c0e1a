#include "components/localization/wheel_step.hpp"

#include <cmath>

namespace bw::localization {

WheelStep step_from_wheels(Time time, Duration over, double left, double right, double separation,
                           double variance_per_metre) {
  WheelStep step;
  step.time = time;
  step.over = over;
  step.distance = (right + left) / 2.0;
  step.turn = (right - left) / separation;
  step.separation = separation;
  const double var_right = variance_per_metre * std::abs(right);
  const double var_left = variance_per_metre * std::abs(left);
  const double both = var_right + var_left;
  const double cross = (var_right - var_left) / (2.0 * separation);
  step.covariance << both / 4.0, cross, cross, both / (separation * separation);
  return step;
}

WheelStep step_from_twist(Time time, Duration over, const Twist2& twist, const Eigen::Matrix2d& covariance) {
  const double seconds = over.to_seconds();
  WheelStep step;
  step.time = time;
  step.over = over;
  step.distance = twist.v * seconds;
  step.turn = twist.omega * seconds;
  step.covariance = covariance * (seconds * seconds);
  return step;
}

WheelStep step_from_poses(Time time, Duration over, const Pose2& from, const Pose2& to, double separation,
                          double variance_per_metre) {
  const Pose2 moved = inverse(from) * to;
  const double half = moved.theta / 2.0;
  const double sinc = std::abs(half) < 1e-6 ? 1.0 : std::sin(half) / half;
  // The chord points along the mean heading; what lies across it is not motion of a differential drive.
  const double distance = moved.position().dot(direction(half)) / sinc;
  const double across = separation * moved.theta / 2.0;
  return step_from_wheels(time, over, distance - across, distance + across, separation, variance_per_metre);
}

}  // namespace bw::localization
