#include "components/localization/ekf/observation.hpp"

#include <numbers>

namespace bw::localization {
namespace {

constexpr double kVarianceFloor = 1e-8;  // (0.1 mm)^2, (0.1 mrad)^2: no sensor is better, and S stays regular

Innovation<kStates, 1> observe_direction(double measured, double predicted, double variance,
                                         const Extrapolated& at) {
  Innovation<kStates, 1> z;
  z.residual(0) = wrap_angle(measured - predicted);
  z.H.setZero();
  z.H.leftCols<3>() = at.by_pose.row(2);
  z.R(0, 0) = variance + at.heading_variance + kVarianceFloor;
  return z;
}

}  // namespace

Innovation<kStates, 2> observe(const PositionFix& fix, const Extrapolated& at) {
  const Vector2 arm = rotate(at.X_MB, fix.antenna);
  Eigen::Matrix<double, 2, 3> by_pose;
  by_pose << 1.0, 0.0, -arm.y(),  //
      0.0, 1.0, arm.x();
  Innovation<kStates, 2> z;
  z.residual = fix.position - at.X_MB.position() - arm;
  z.H.setZero();
  z.H.leftCols<3>() = by_pose * at.by_pose;
  z.R = 0.5 * (fix.covariance + fix.covariance.transpose());
  z.R.diagonal().array() += at.position_variance + kVarianceFloor;
  return z;
}

Innovation<kStates, 1> observe(const RangeReading& reading, const Extrapolated& at) {
  const Vector2 arm = rotate(at.X_MB, reading.antenna);
  const Vector2 from_anchor = at.X_MB.position() + arm - reading.anchor;
  const double distance = from_anchor.norm();
  // At the anchor itself a range has no direction: any will do, and none is believed.
  const Vector2 direction = distance > 1e-6 ? Vector2(from_anchor / distance) : Vector2(0.0, 0.0);
  Eigen::Matrix<double, 1, 3> by_pose;
  by_pose << direction.x(), direction.y(), direction.y() * arm.x() - direction.x() * arm.y();
  Innovation<kStates, 1> z;
  z.residual(0) = reading.range - distance;
  z.H.setZero();
  z.H.leftCols<3>() = by_pose * at.by_pose;
  z.R(0, 0) = reading.variance + at.position_variance + kVarianceFloor;
  return z;
}

Innovation<kStates, 3> observe(const PoseReading& reading, const Extrapolated& at) {
  Innovation<kStates, 3> z;
  z.residual << reading.X_MB.x - at.X_MB.x, reading.X_MB.y - at.X_MB.y,
      wrap_angle(reading.X_MB.theta - at.X_MB.theta);
  z.H.setZero();
  z.H.leftCols<3>() = at.by_pose;
  z.R = 0.5 * (reading.covariance + reading.covariance.transpose());
  z.R.diagonal().array() += kVarianceFloor;
  z.R(0, 0) += at.position_variance;
  z.R(1, 1) += at.position_variance;
  z.R(2, 2) += at.heading_variance;
  return z;
}

Innovation<kStates, 1> observe(const HeadingReading& reading, const Extrapolated& at, double heading_offset) {
  Innovation<kStates, 1> z =
      observe_direction(reading.heading, at.X_MB.theta + heading_offset, reading.variance, at);
  z.H(0, 4) = 1.0;
  return z;
}

Innovation<kStates, 1> observe(const CourseReading& reading, const Extrapolated& at, bool backward) {
  const double rotated = backward ? std::numbers::pi : 0.0;
  return observe_direction(reading.course, at.X_MB.theta + rotated, reading.variance, at);
}

}  // namespace bw::localization
