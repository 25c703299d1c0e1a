// Where the robot was, for a localization whose process is started again in place of one that was killed. The odometry
// goes on meanwhile, so that the pose comes back with it, wherever the robot has moved to.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw::localization {

struct KeptPose {
  Time time;  ///< of the odometry
  Pose2 X_OB;
  Pose2 X_MB;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of (x, y, theta)
};

/// What is known of the pose when the odometry goes on at `X_OB`: the covariance grows by a tenth of the way and of the
/// turn that nobody measured, and by 2 cm and 0.02 rad. Nothing where the odometry cannot be the same one: earlier, or
/// farther than 2 m/s and 0.2 m would lead.
std::optional<KeptPose> carried_on(const KeptPose& kept, const Pose2& X_OB, Time time);

}  // namespace bw::localization
