#include "components/model/wheel_step.hpp"

#include <cmath>

namespace bw {

double rotation_rounding(double tick, double separation) {
  return tick * tick / (6.0 * separation * separation);
}

WheelStep step_from_wheels(Time time, Duration over, double left, double right, double separation,
                           double variance_per_metre) {
  WheelStep step;
  step.time = time;
  step.over = over;
  step.distance = (right + left) / 2.0;
  step.rotation = (right - left) / separation;
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
  step.rotation = twist.omega * seconds;
  step.covariance = covariance * (seconds * seconds);
  return step;
}

WheelStep step_from_poses(Time time, Duration over, const Pose2& from, const Pose2& to, double separation,
                          double variance_per_metre) {
  const ArcTravel arc = arc_between(from, to);
  const double across = separation * arc.rotation / 2.0;
  return step_from_wheels(time, over, arc.distance - across, arc.distance + across, separation,
                          variance_per_metre);
}

std::optional<double> declared_variance_per_metre(double heading_variance_before,
                                                  double heading_variance_after, const ArcTravel& arc,
                                                  double separation) {
  const double across = separation * arc.rotation / 2.0;
  const double distance = std::abs(arc.distance + across) + std::abs(arc.distance - across);
  const double growth = heading_variance_after - heading_variance_before;
  if (!(growth > 0.0) || !(distance > 0.0)) return std::nullopt;
  const double k = growth * separation * separation / distance;
  return std::isfinite(k) ? std::optional(k) : std::nullopt;
}

Eigen::Matrix3d covariance_after(const Pose2& X_OB, const Eigen::Matrix3d& C, const WheelStep& step) {
  const ArcStep arc = arc_step(X_OB, step.distance, step.rotation);
  return arc.by_pose * C * arc.by_pose.transpose() + arc.by_step * step.covariance * arc.by_step.transpose();
}

}  // namespace bw
