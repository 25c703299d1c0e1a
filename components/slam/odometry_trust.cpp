#include "components/slam/odometry_trust.hpp"

#include <algorithm>
#include <cmath>

namespace bw::slam {
namespace {

constexpr double kLeast = 0.002;  // of the variance
constexpr double kLargest = 10.0;
constexpr double kShareUp = 0.2;  // of a step that odometry was worse than thought
constexpr double kShareDown = 0.03;

constexpr double kMostSigma = 0.04;      // [m] of a scan that tells travel
constexpr double kMostTurnSigma = 0.01;  // [rad]
constexpr double kStepNoise = 1e-3;      // [m], [rad] of any step

void learn_one(double squared, double of_scan, double assumed, double& factor) {
  const double seen = std::clamp((squared - of_scan) / assumed, kLeast, 4.0 * kLargest);
  factor += (seen > factor ? kShareUp : kShareDown) * (seen - factor);
  factor = std::clamp(factor, kLeast, kLargest);
}

}  // namespace

Eigen::Matrix3d step_covariance(const Pose2& step, const SlamOptions& options) {
  const double travel = std::hypot(step.x, step.y);
  const double along =
      options.odometry_travel_noise * options.odometry_travel_noise * travel + kStepNoise * kStepNoise;
  const double turn = options.odometry_turn_noise * options.odometry_turn_noise * std::abs(step.theta) +
                      options.odometry_heading_noise * options.odometry_heading_noise * travel +
                      kStepNoise * kStepNoise;
  return Eigen::Vector3d{along, along, turn}.asDiagonal();
}

Eigen::Matrix3d OdometryTrust::covariance(const Pose2& step, const SlamOptions& options) const {
  const Eigen::Vector3d factors{travel_, travel_, turn_};
  return step_covariance(step, options) * factors.asDiagonal();
}

void OdometryTrust::learn(const Pose2& odometry, const Pose2& corrected, const Eigen::Matrix3d& predicted,
                          const Eigen::Matrix3d& information, const SlamOptions& options) {
  const double travel = std::hypot(odometry.x, odometry.y);
  const Eigen::Matrix3d assumed = step_covariance(odometry, options);
  const Eigen::Matrix3d of_scan = (information + 1e-3 * Eigen::Matrix3d::Identity()).inverse();
  // What the scan alone would have moved: the prior held it back.
  const Eigen::Matrix3d prior = (predicted + 1e-12 * Eigen::Matrix3d::Identity()).inverse();
  const Eigen::Vector3d e = (Eigen::Matrix3d::Identity() + of_scan * prior) * difference(corrected, odometry);
  const Eigen::Vector3d factors{travel_, travel_, turn_};
  const Eigen::Vector3d others = (of_scan + predicted).diagonal() - factors.cwiseProduct(assumed.diagonal());
  if (of_scan(2, 2) < kMostTurnSigma * kMostTurnSigma)
    learn_one(e.z() * e.z(), others(2), assumed(2, 2), turn_);
  // Along the way alone: across it is the heading that errs.
  if (of_scan(0, 0) < kMostSigma * kMostSigma && travel > 0.05)
    learn_one(e.x() * e.x(), others(0), assumed(0, 0), travel_);
}

}  // namespace bw::slam
