// What the wheels say of the motion, with how sure they are of it. Frames: B base_link, O odom.
#pragma once

#include <Eigen/Core>

#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw {

struct OdometryState {
  Time time;
  Pose2 X_OB;                                                  ///< base_link in odom
  Twist2 twist;                                                ///< body velocity over the window
  Eigen::Matrix3d pose_covariance = Eigen::Matrix3d::Zero();   ///< of (x, y, theta) [m, rad]
  Eigen::Matrix2d twist_covariance = Eigen::Matrix2d::Zero();  ///< of (v, omega)
  double left_angle = 0.0;  ///< rotated by the left wheel since the start [rad]
  double right_angle = 0.0;
};

}  // namespace bw
