// Wheel steps from what bases give: travel of two wheels, a measured twist, or poses of an odometry.
#pragma once

#include "components/localization/measurements.hpp"

namespace bw::localization {

/// From the travel of each wheel [m] since the last step: distance = (R + L) / 2, turn = (R - L) /
/// separation; covariance from diag(k |R|, k |L|), k = variance_per_metre [m] (book 2.2).
WheelStep step_from_wheels(Time time, Duration over, double left, double right, double separation,
                           double variance_per_metre);

/// From a twist that held during `over`; covariance is that of (v, omega).
WheelStep step_from_twist(Time time, Duration over, const Twist2& twist, const Eigen::Matrix2d& covariance);

/// From two poses of an odometry frame: the arc that turns by their difference in heading and whose chord is
/// the way between them along the mean heading (negative: backward). Covariance as if `separation` apart
/// wheels had measured it.
WheelStep step_from_poses(Time time, Duration over, const Pose2& from, const Pose2& to, double separation,
                          double variance_per_metre);

}  // namespace bw::localization
