#include "components/other_robots/robot_tracks.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace bw {
namespace {

/// Standard deviation of the less certain axis [m]; NaN when there is none.
double largest_deviation(const Eigen::Matrix2d& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(covariance, Eigen::EigenvaluesOnly);
  return std::sqrt(axes.eigenvalues().maxCoeff());
}

}  // namespace

std::string fault_of(const RobotReport& report, Time now, const OtherRobotsOptions& options) {
  if (!is_finite(report.X_MR) || !is_finite(report.twist) || !report.covariance.allFinite())
    return "its pose or velocity is not finite";
  if (std::abs((now - report.time).to_seconds()) > options.timeout) return "its stamps are not of now";
  if (!(largest_deviation(report.covariance) <= options.kMaxDeviation)) return "it is not sure of its place";
  return {};
}

TrackedPerson robot_track(const RobotReport& report, const Pose2& X_FM, Time time, std::uint32_t id,
                          double radius, const OtherRobotsOptions& options) {
  const Vector2 velocity = direction(report.X_MR.theta) * report.twist.v;
  const double age = (time - report.time).to_seconds();
  const Eigen::Matrix2d R = Eigen::Rotation2Dd(X_FM.theta).toRotationMatrix();
  return robot_track(X_FM * Vector2(report.X_MR.position() + velocity * age), rotate(X_FM, velocity),
                     R * report.covariance * R.transpose(), time, id, radius, options);
}

TrackedPerson robot_track(const Vector2& position, const Vector2& velocity, const Eigen::Matrix2d& covariance,
                          Time time, std::uint32_t id, double radius, const OtherRobotsOptions& options) {
  TrackedPerson track;
  track.id = id;
  track.radius = radius;
  track.position = position;
  track.velocity = velocity;
  track.covariance.topLeftCorner<2, 2>() = covariance;
  track.born = track.confirmed = track.last_seen = time;
  const int steps = static_cast<int>(std::floor(options.prediction_horizon / options.prediction_step + 1e-9));
  for (int i = 1; i <= steps; ++i) {
    const double t = i * options.prediction_step;
    const double deviation = options.acceleration * t * t / 2.0;
    track.predictions.push_back(
        {.time = t,
         .position = position + velocity * t,
         .covariance = covariance + deviation * deviation * Eigen::Matrix2d::Identity()});
  }
  return track;
}

}  // namespace bw
