// Wheel steps from what bases give: travel of two wheels, a measured twist, or poses of an odometry.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "components/model/arc.hpp"
#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw {

/// Travel along an arc during [time - over, time], as wheels measure it.
struct WheelStep {
  Time time;
  int source = 0;
  Duration over;
  double distance = 0.0;                                 ///< forward [m]
  double rotation = 0.0;                                 ///< counter-clockwise [rad]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< of (distance, rotation); may be singular
  double separation = 0.0;  ///< of the wheels [m]; 0: not two wheels, or not known
  /// Variance of the rotation [rad^2] by which counts are rounded at either end; steps that adjoin share it,
  /// so that it never adds up. Not in `covariance`. 0: counts are fine, or not known.
  double rounding = 0.0;
};

/// WheelStep::rounding of two wheels whose counts are `tick` [m] apart: tick^2 / 12 for each (uniform), over
/// separation^2.
double rotation_rounding(double tick, double separation);

/// From the travel of each wheel [m] since the last step: distance = (R + L) / 2, rotation = (R - L) /
/// separation; covariance from diag(k |R|, k |L|), k = variance_per_metre [m] (README.md 2.2).
WheelStep step_from_wheels(Time time, Duration over, double left, double right, double separation,
                           double variance_per_metre);

/// From a twist that held during `over`; covariance is that of (v, omega).
WheelStep step_from_twist(Time time, Duration over, const Twist2& twist, const Eigen::Matrix2d& covariance);

/// From two poses of an odometry frame: the arc between them (arc.hpp), with the covariance as if two wheels
/// `separation` apart had measured it.
WheelStep step_from_poses(Time time, Duration over, const Pose2& from, const Pose2& to, double separation,
                          double variance_per_metre);

/// The k [m] of step_from_wheels() by which an odometry's own covariance grew on an arc: the variance of its
/// heading, which no lever enlarges, grows by k (|R| + |L|) / separation^2. Nothing where it did not grow or
/// the wheels did not move: the odometry declares none.
std::optional<double> declared_variance_per_metre(double heading_variance_before,
                                                  double heading_variance_after, const ArcTravel& arc,
                                                  double separation);

/// Covariance of (x, y, theta) after `step` from X_OB, where it was C: F C F^T + G Q G^T, F and G the
/// derivatives of arc.hpp.
Eigen::Matrix3d covariance_after(const Pose2& X_OB, const Eigen::Matrix3d& C, const WheelStep& step);

}  // namespace bw
