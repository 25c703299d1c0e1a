#include "components/people/tracker/heading_model.hpp"

#include <cmath>

namespace bw::people {
HeadingState walked(const HeadingState& x, double dt) {
  HeadingState after = x;
  after.head<2>() += x[3] * dt * direction(x[2]);
  return after;
}

HeadingCovariance walked_jacobian(const HeadingState& x, double dt) {
  const Vector2 along = direction(x[2]);
  HeadingCovariance F = HeadingCovariance::Identity();
  F.block<2, 1>(0, 2) = x[3] * dt * Vector2(-along.y(), along.x());
  F.block<2, 1>(0, 3) = dt * along;
  return F;
}

HeadingCovariance walked_noise(const HeadingState& x, double dt, const HeadingNoise& noise) {
  const double a = noise.acceleration * noise.acceleration;
  const double h = noise.heading * noise.heading;
  const double v = x[3];
  const double dt2 = dt * dt;
  const double dt3 = dt2 * dt;
  // Along and across the path: integrated once and twice.
  HeadingCovariance Q = HeadingCovariance::Zero();
  Q(0, 0) = a * dt3 / 3.0;
  Q(0, 3) = Q(3, 0) = a * dt2 / 2.0;
  Q(3, 3) = a * dt;
  Q(1, 1) = v * v * h * dt3 / 3.0;
  Q(1, 2) = Q(2, 1) = v * h * dt2 / 2.0;
  Q(2, 2) = h * dt;
  HeadingCovariance R = HeadingCovariance::Identity();
  R.col(0).head<2>() = direction(x[2]);
  R.col(1).head<2>() = Vector2(-R(1, 0), R(0, 0));
  return R * Q * R.transpose();
}

Eigen::Vector4d without_heading(const HeadingState& x) {
  Eigen::Vector4d m;
  m << x.head<2>(), x[3] * direction(x[2]);
  return m;
}

Eigen::Matrix4d covariance_without_heading(const HeadingState& x, const HeadingCovariance& P) {
  // With the heading's error e of variance s, and b its covariance with the speed:
  //   E[u e^(i e)] = exp(-s / 2) (v + i b),   E[u^2 e^(2 i e)] = exp(-2 s) ((v + 2 i b)^2 + Pvv)
  const double v = x[3];
  const double s = P(2, 2);
  const double b = P(2, 3);
  const double square = v * v + P(3, 3);
  const double twice = std::exp(-2.0 * s) * (square - 4.0 * b * b);
  const double once = std::exp(-s / 2.0);
  // Along and across the path, about the velocity (v, 0) that is reported.
  Eigen::Matrix2d V;
  V(0, 0) = (square + twice) / 2.0 - 2.0 * v * v * once + v * v;
  V(1, 1) = (square - twice) / 2.0;
  V(0, 1) = V(1, 0) = v * b * (2.0 * std::exp(-2.0 * s) - once);
  Eigen::Matrix2d W;  // of the position with it
  W << once * (P.block<2, 1>(0, 3) - b * P.block<2, 1>(0, 2)), once * v * P.block<2, 1>(0, 2);
  Eigen::Matrix2d R;
  R.col(0) = direction(x[2]);
  R.col(1) = Vector2(-R(1, 0), R(0, 0));
  Eigen::Matrix4d C;
  C.topLeftCorner<2, 2>() = P.topLeftCorner<2, 2>();
  C.topRightCorner<2, 2>() = W * R.transpose();
  C.bottomLeftCorner<2, 2>() = C.topRightCorner<2, 2>().transpose();
  C.bottomRightCorner<2, 2>() = R * V * R.transpose();
  return C;
}

HeadingState with_heading(const Eigen::Vector4d& m) {
  HeadingState x;
  x << m.head<2>(), std::atan2(m[3], m[2]), m.tail<2>().norm();
  return x;
}

HeadingCovariance with_heading_jacobian(const Eigen::Vector4d& m) {
  const double speed = m.tail<2>().norm();
  const Vector2 along = m.tail<2>() / speed;
  HeadingCovariance J = HeadingCovariance::Zero();
  J(0, 0) = J(1, 1) = 1.0;
  J.block<1, 2>(2, 2) = Vector2(-along.y(), along.x()).transpose() / speed;
  J.block<1, 2>(3, 2) = along.transpose();
  return J;
}

Eigen::Matrix4d glide(double dt) {
  Eigen::Matrix4d F = Eigen::Matrix4d::Identity();
  F(0, 2) = F(1, 3) = dt;
  return F;
}

Eigen::Matrix4d glide_noise(double dt, double acceleration) {
  const double q = acceleration * acceleration;
  Eigen::Matrix4d Q = Eigen::Matrix4d::Zero();
  Q(0, 0) = Q(1, 1) = q * dt * dt * dt / 3.0;
  Q(0, 2) = Q(2, 0) = Q(1, 3) = Q(3, 1) = q * dt * dt / 2.0;
  Q(2, 2) = Q(3, 3) = q * dt;
  return Q;
}

}  // namespace bw::people
