// A relative pose that is not sure: first order, errors added to (x, y, theta).
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include "runtime/base/pose2.hpp"

namespace bw::slam {

/// X_AB, and the covariance of its (x, y, theta) in A [m, m, rad].
struct UncertainPose {
  Pose2 X;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// How (x, y, theta) of X_AB * X_BC move with those of X_AB.
inline Eigen::Matrix3d by_first(const Pose2& X_AB, const Pose2& X_BC) {
  const Vector2 arm = rotate(X_AB, X_BC.position());
  Eigen::Matrix3d J = Eigen::Matrix3d::Identity();
  J(0, 2) = -arm.y();
  J(1, 2) = arm.x();
  return J;
}

/// How they move with those of X_BC: A's axes seen from B.
inline Eigen::Matrix3d by_second(const Pose2& X_AB) {
  Eigen::Matrix3d J = Eigen::Matrix3d::Identity();
  J.topLeftCorner<2, 2>() << std::cos(X_AB.theta), -std::sin(X_AB.theta), std::sin(X_AB.theta),
      std::cos(X_AB.theta);
  return J;
}

/// X_AC of X_AB and X_BC whose errors are independent.
inline UncertainPose operator*(const UncertainPose& X_AB, const UncertainPose& X_BC) {
  const Eigen::Matrix3d J1 = by_first(X_AB.X, X_BC.X);
  const Eigen::Matrix3d J2 = by_second(X_AB.X);
  return {X_AB.X * X_BC.X, J1 * X_AB.covariance * J1.transpose() + J2 * X_BC.covariance * J2.transpose()};
}

/// X_BA of X_AB.
inline UncertainPose inverse(const UncertainPose& X_AB) {
  const Pose2 X_BA = bw::inverse(X_AB.X);
  // p_BA = -R^T p: its derivative by p is -R^T, by theta the position turned by a quarter.
  Eigen::Matrix3d J = -by_second(X_BA);
  J(2, 2) = -1.0;
  J(0, 2) = X_BA.y;
  J(1, 2) = -X_BA.x;
  return {X_BA, J * X_AB.covariance * J.transpose()};
}

/// How unsure, as one number [m^2]: of the position, and of what lies 5 m away.
inline double spread(const Eigen::Matrix3d& covariance) {
  constexpr double kArm = 5.0;
  return covariance(0, 0) + covariance(1, 1) + kArm * kArm * covariance(2, 2);
}

/// (x, y, theta) of the difference between two poses in one frame, the angle wrapped.
inline Eigen::Vector3d difference(const Pose2& a, const Pose2& b) {
  return {a.x - b.x, a.y - b.y, wrap_angle(a.theta - b.theta)};
}

/// Squared Mahalanobis distance between two that tell the same pose, their errors independent: chi-square of three
/// degrees of freedom.
inline double squared_distance(const UncertainPose& a, const UncertainPose& b) {
  const Eigen::Vector3d e = difference(a.X, b.X);
  const Eigen::Matrix3d C = a.covariance + b.covariance;
  return e.dot(C.inverse() * e);
}

}  // namespace bw::slam
