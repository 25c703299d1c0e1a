#include "components/robot_base/calibration/calibrate_odometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "components/model/wheel_step.hpp"

namespace bw {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Of nothing more than that it is a robot: sd of the logarithms of radius, ratio and separation.
constexpr std::array kPrior = {0.2, 0.1, 0.2};

WheelGeometry scaled(const WheelGeometry& start, const Vector3d& logarithms) {
  return {start.radius * std::exp(logarithms[0]), start.ratio * std::exp(logarithms[1]),
          start.separation * std::exp(logarithms[2])};
}

WheelStep step_of(const WheelRotations& rotations, const WheelGeometry& geometry, double variance_per_metre) {
  const double left_radius = geometry.radius * 2.0 / (1.0 + geometry.ratio);
  return step_from_wheels({}, {}, rotations.left * left_radius,
                          rotations.right * left_radius * geometry.ratio, geometry.separation,
                          variance_per_metre);
}

struct Rolled {
  Pose2 pose;
  Matrix3d covariance = Matrix3d::Zero();
};

Rolled rolled_with_covariance(const MeasuredMotion& motion, const WheelGeometry& geometry,
                              const MeasuringErrors& errors) {
  Rolled result;
  for (const WheelRotations& rotations : motion.rotations) {
    const WheelStep step = step_of(rotations, geometry, errors.variance_per_metre);
    result.covariance = covariance_after(result.pose, result.covariance, step);
    result.pose = advance_arc(result.pose, step.distance, step.rotation);
  }
  // Both ends are measured; the heading at the start rotates what was moved.
  const double heading = errors.heading * errors.heading;
  const Vector3d lever(-motion.moved.y, motion.moved.x, 1.0);
  result.covariance += heading * lever * lever.transpose();
  result.covariance.diagonal() += Vector3d(2.0, 2.0, 0.0) * errors.position * errors.position;
  result.covariance(2, 2) += heading;
  return result;
}

/// What is known of a motion's end, as rows: distance, or x and y, or the pose.
VectorXd difference(const MeasuredMotion& motion, const Pose2& pose) {
  using Known = MeasuredMotion::Known;
  if (motion.known == Known::distance)
    return VectorXd::Constant(1, pose.position().norm() - std::abs(motion.moved.x));
  VectorXd rows(motion.known == Known::pose ? 3 : 2);
  rows.head<2>() = pose.position() - motion.moved.position();
  if (motion.known == Known::pose) rows[2] = wrap_angle(pose.theta - motion.moved.theta);
  return rows;
}

MatrixXd covariance_of(const MeasuredMotion& motion, const Rolled& at) {
  using Known = MeasuredMotion::Known;
  if (motion.known != Known::distance) {
    const Eigen::Index rows = motion.known == Known::pose ? 3 : 2;
    return at.covariance.topLeftCorner(rows, rows);
  }
  const Vector2 along = at.pose.position().normalized();
  return MatrixXd::Constant(1, 1, along.dot(at.covariance.topLeftCorner<2, 2>() * along));
}

struct Normal {
  Matrix3d information = Matrix3d::Zero();
  Vector3d gradient = Vector3d::Zero();
  double squares = 0.0;  ///< of the motions alone
  Eigen::Index rows = 0;
};

void add(const MeasuredMotion& motion, const WheelGeometry& start, const Vector3d& logarithms,
         const MeasuringErrors& errors, Normal& normal) {
  constexpr double kStep = 1e-6;
  const Rolled at = rolled_with_covariance(motion, scaled(start, logarithms), errors);
  const VectorXd rest = difference(motion, at.pose);
  MatrixXd slope(rest.size(), 3);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Vector3d moved = logarithms + kStep * Vector3d::Unit(i);
    VectorXd change = difference(motion, rolled(motion.rotations, scaled(start, moved))) - rest;
    if (change.size() == 3) change[2] = wrap_angle(change[2]);
    slope.col(i) = change / kStep;
  }
  const MatrixXd weight = covariance_of(motion, at).llt().solve(MatrixXd::Identity(rest.size(), rest.size()));
  normal.information += slope.transpose() * weight * slope;
  normal.gradient += slope.transpose() * weight * rest;
  normal.squares += rest.dot(weight * rest);
  normal.rows += rest.size();
}

Matrix3d prior_information() {
  const auto weight = [](double sd) { return 1.0 / (sd * sd); };
  return Vector3d(weight(kPrior[0]), weight(kPrior[1]), weight(kPrior[2])).asDiagonal();
}

}  // namespace

Pose2 rolled(const std::vector<WheelRotations>& rotations, const WheelGeometry& geometry) {
  Pose2 pose;
  for (const WheelRotations& one : rotations) {
    const WheelStep step = step_of(one, geometry, 0.0);
    pose = advance_arc(pose, step.distance, step.rotation);
  }
  return pose;
}

std::optional<Calibration> calibrate_odometry(const std::vector<MeasuredMotion>& motions,
                                              const WheelGeometry& start, const MeasuringErrors& errors) {
  constexpr int kIterations = 20;
  if (motions.empty()) return std::nullopt;
  Vector3d logarithms = Vector3d::Zero();
  Normal normal;
  Matrix3d covariance;
  for (int i = 0; i < kIterations; ++i) {
    normal = {};
    for (const MeasuredMotion& motion : motions) add(motion, start, logarithms, errors, normal);
    const Matrix3d information = normal.information + prior_information();
    covariance = information.llt().solve(Matrix3d::Identity());
    const Vector3d change = -covariance * (normal.gradient + prior_information() * logarithms);
    if (!change.allFinite()) return std::nullopt;
    logarithms += change.cwiseMax(-0.1).cwiseMin(0.1);
    if (change.norm() < 1e-10) break;
  }
  // A few motions agree by chance: they do not tell how large their errors are.
  constexpr Eigen::Index kEnough = 6;
  const Eigen::Index free = normal.rows - 3;
  const double agreement = normal.squares / static_cast<double>(std::max<Eigen::Index>(free, 1));
  const double unexplained = free < kEnough ? std::max(agreement, 1.0) : agreement;
  const Vector3d sd = (covariance.diagonal() * unexplained).cwiseSqrt();
  return Calibration{.geometry = scaled(start, logarithms),
                     .share_of_error = {sd[0], sd[1], sd[2]},
                     .disagreement = std::sqrt(agreement)};
}

}  // namespace bw
