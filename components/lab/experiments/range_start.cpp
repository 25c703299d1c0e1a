#include "components/lab/experiments/range_start.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <Eigen/Cholesky>

namespace bw {
namespace {

constexpr int kHeadings = 16;
constexpr int kIterations = 30;
constexpr std::size_t kLeastRanges = 8;
constexpr double kCaution = 4.0;  // times the variance: ranges share errors, walls make them long

struct Sighting {
  Vector2 p_O;  ///< where the robot was, in its odometry
  const RangeSample* range;
};

struct Fit {
  Pose2 X_MO;
  double cost = std::numeric_limits<double>::infinity();
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
};

/// Odometry at a stamp, from the samples around it; nothing outside of them.
std::optional<OdometrySample> odometry_at(const RecordedDrive& drive, Time time) {
  const auto after = std::lower_bound(drive.odometry.begin(), drive.odometry.end(), time,
                                      [](const OdometrySample& sample, Time t) { return sample.time < t; });
  if (after == drive.odometry.end()) return std::nullopt;
  if (after->time == time) return *after;
  if (after == drive.odometry.begin()) return std::nullopt;
  return advance(*(after - 1), after->twist, time);
}

// sum of log(1 + e^2), e in standard deviations; weight of each 1 / (1 + e^2).
Fit refine(Pose2 X_MO, const std::vector<Sighting>& sightings) {
  Fit fit;
  for (int i = 0; i < kIterations; ++i) {
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    double cost = 0.0;
    for (const Sighting& s : sightings) {
      const Vector2 arm = rotate(X_MO, s.p_O);
      const Vector2 from_anchor = X_MO.position() + arm - s.range->anchor;
      const double distance = std::max(from_anchor.norm(), 1e-6);
      const Vector2 u = from_anchor / distance;
      const Eigen::Vector3d J(u.x(), u.y(), cross(arm, u));
      const double residual = s.range->range - distance;
      const double squares = residual * residual / s.range->variance;
      const double weight = 1.0 / ((1.0 + squares) * s.range->variance);
      information += weight * J * J.transpose();
      gradient += weight * residual * J;
      cost += std::log1p(squares);
    }
    if (cost < fit.cost) fit = {X_MO, cost, information};
    const Eigen::Matrix3d damped = information + 1e-3 * Eigen::Matrix3d::Identity();
    const Eigen::Vector3d step = damped.ldlt().solve(gradient);
    X_MO = {X_MO.x + step(0), X_MO.y + step(1), wrap_angle(X_MO.theta + step(2))};
    if (step.norm() < 1e-9) break;
  }
  return fit;
}

Fit best_fit(const std::vector<Sighting>& sightings) {
  Vector2 centre(0.0, 0.0);
  for (const Sighting& s : sightings) centre += s.range->anchor / static_cast<double>(sightings.size());
  Fit best;
  for (int i = 0; i < kHeadings; ++i) {
    const double theta = wrap_angle(2.0 * std::numbers::pi * i / kHeadings);
    const Fit fit = refine({centre.x(), centre.y(), theta}, sightings);
    if (fit.cost < best.cost) best = fit;
  }
  return best;
}

}  // namespace

std::optional<RangeStart> range_start(const RecordedDrive& drive, double heading_sigma) {
  std::vector<Sighting> sightings;
  for (const RangeSample& range : drive.ranges) {
    const auto at = odometry_at(drive, range.time);
    if (!at) continue;
    sightings.push_back({at->X_OB.position(), &range});
    if (sightings.size() < kLeastRanges) continue;
    const Fit fit = best_fit(sightings);
    const Eigen::LDLT<Eigen::Matrix3d> factors(fit.information);
    const Eigen::Matrix3d C = kCaution * factors.solve(Eigen::Matrix3d::Identity());
    if (!(factors.rcond() > 1e-9 && C(2, 2) > 0.0 && C(2, 2) <= heading_sigma * heading_sigma)) continue;
    // From the odometry's frame to the base: the heading moves the base by its arm.
    const Vector2 arm = rotate(fit.X_MO, at->X_OB.position());
    Eigen::Matrix3d J = Eigen::Matrix3d::Identity();
    J(0, 2) = -arm.y();
    J(1, 2) = arm.x();
    return RangeStart{range.time, fit.X_MO * at->X_OB, J * C * J.transpose()};
  }
  return std::nullopt;
}

}  // namespace bw
