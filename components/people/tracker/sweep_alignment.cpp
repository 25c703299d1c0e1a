#include "components/people/tracker/sweep_alignment.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>

namespace bw::people {
namespace {

constexpr int kRounds = 3;
constexpr int kFewest = 40;       // points
constexpr int kBaseline = 2;      // beams to either side that make a line
constexpr double kBreak = 0.25;   // [m] of range between them: a step is no surface
constexpr double kFar = 1.0;      // [m] from a sweep: another is compared with
constexpr double kRotated = 2.5;  // [rad]
constexpr double kAtRest = 1e-6;  // [m, rad]

Vector2 rotated_left(const Vector2& v) { return {-v.y(), v.x()}; }

float longest(const std::vector<float>& ranges) {
  float most = 0.0F;
  for (const float r : ranges) most = std::max(most, r);
  return most;
}

}  // namespace

Vector2 SweepAlignment::remembered_point(std::size_t beam) const {
  return sensor_ + static_cast<double>(ranges_[beam]) * directions_[beam];
}

/// The line through the beams around the one that looks towards `p_O`.
bool SweepAlignment::surface_towards(const Vector2& p_O, Surface& surface) const {
  constexpr double kTwoPi = 2.0 * std::numbers::pi;
  const Vector2 offset = p_O - sensor_;
  double angle = std::atan2(offset.y(), offset.x()) - angle_min_;
  angle -= kTwoPi * std::floor(angle / kTwoPi);
  const double beam = std::round(angle / angle_increment_);
  if (!(beam >= kBaseline && beam + kBaseline < static_cast<double>(ranges_.size()))) return false;
  const auto middle = static_cast<std::size_t>(beam);
  for (std::size_t i = middle - kBaseline; i <= middle + kBaseline; ++i) {
    if (!(ranges_[i] > 0.0F && ranges_[i] < no_return_)) return false;
    if (std::abs(ranges_[i] - ranges_[middle]) > static_cast<float>(kBreak)) return false;
  }
  Vector2 mean(0.0, 0.0);
  for (std::size_t i = middle - kBaseline; i <= middle + kBaseline; ++i) mean += remembered_point(i);
  surface.point = mean / (2 * kBaseline + 1);
  const Vector2 along =
      2.0 * (remembered_point(middle + kBaseline) - remembered_point(middle - kBaseline)) +
      (remembered_point(middle + 1) - remembered_point(middle - 1));  // least squares over even beams
  const double length = along.norm();
  if (length < 1e-6) return false;
  surface.normal = rotated_left(along / length);
  return true;
}

// Normal equations of the points' distances from the surfaces they look at, at `correction` (x, y, rotation
// about the sensor); what is farther than `reach` has no weight (Tukey).
SweepAlignment::Equations SweepAlignment::compare(const DetectionSet& sweep, const View& view,
                                                  const Eigen::Vector3d& correction, double reach) const {
  const Eigen::Vector3d prior(1.0 / (options_.kTranslationSigma * options_.kTranslationSigma),
                              1.0 / (options_.kTranslationSigma * options_.kTranslationSigma),
                              1.0 / (options_.kRotationSigma * options_.kRotationSigma));
  const double weight = 1.0 / (1.2 * options_.kRangeNoise * options_.kRangeNoise);  // the line errs as well
  const float no_return = longest(sweep.free_ranges);
  const Vector2 rotation = direction(correction(2));
  Equations sum;
  sum.information = prior.asDiagonal();
  sum.pull = -(prior.array() * correction.array()).matrix();
  for (std::size_t i = 0; i < sweep.free_ranges.size(); ++i) {
    const float range = sweep.free_ranges[i];
    if (!(range > 0.0F && range < no_return)) continue;
    const double angle = view.angle_min + static_cast<double>(i) * sweep.angle_increment;
    const Vector2 beam = static_cast<double>(range) * direction(angle);
    const Vector2 arm(rotation.x() * beam.x() - rotation.y() * beam.y(),
                      rotation.y() * beam.x() + rotation.x() * beam.y());
    const Vector2 point = view.sensor + arm + correction.head<2>();
    Surface surface;
    if (!surface_towards(point, surface)) continue;
    ++sum.compared;
    const double miss = surface.normal.dot(surface.point - point);
    const double share = miss / reach;
    if (std::abs(share) >= 1.0) continue;
    ++sum.fitting;
    const double trust = (1.0 - share * share) * (1.0 - share * share) * weight;
    const Eigen::Vector3d J(surface.normal.x(), surface.normal.y(), surface.normal.dot(rotated_left(arm)));
    sum.information += trust * J * J.transpose();
    sum.pull += trust * miss * J;
  }
  return sum;
}

std::optional<Eigen::Vector3d> SweepAlignment::correction_of(const DetectionSet& sweep,
                                                             const View& view) const {
  Eigen::Vector3d correction = Eigen::Vector3d::Zero();
  for (int round = 0; round < kRounds; ++round) {
    const double reach = round == 0 ? options_.kReach : std::min(options_.kReach, 5.0 * options_.kRangeNoise);
    const Equations sum = compare(sweep, view, correction, reach);
    if (sum.fitting < kFewest || sum.fitting < options_.kLeastShare * sum.compared) return std::nullopt;
    correction += sum.information.ldlt().solve(sum.pull);
  }
  return correction.allFinite() ? std::optional(correction) : std::nullopt;
}

Pose2 SweepAlignment::align(const DetectionSet& sweep) {
  const bool usable = sweep.angle_increment > 0.0 && !sweep.free_ranges.empty();
  const bool moved = !last_ || (sweep.sensor - last_->sensor).norm() > kAtRest ||
                     std::abs(wrap_angle(sweep.angle_min - last_->angle_min)) > kAtRest;
  last_ = View{sweep.sensor, sweep.angle_min};
  if (usable && !ranges_.empty() && !moved) return {};
  const View view{X_RO_ * sweep.sensor, wrap_angle(sweep.angle_min + X_RO_.theta)};
  std::optional<Eigen::Vector3d> correction;
  if (usable && !ranges_.empty()) correction = correction_of(sweep, view);
  if (!correction) {
    remember(sweep);
    return {};
  }
  // p -> s + t + R (p - s)
  const Pose2 R{0.0, 0.0, (*correction)(2)};
  const Vector2 shift = view.sensor + correction->head<2>() - R * view.sensor;
  const Pose2 X_RO = Pose2{shift.x(), shift.y(), (*correction)(2)} * X_RO_;
  const Pose2 X_PO = inverse(X_RO_) * X_RO;
  X_RO_ = X_RO;
  const bool far = (X_RO_ * sweep.sensor - sensor_).norm() > kFar ||
                   std::abs(wrap_angle(sweep.angle_min + X_RO_.theta - angle_min_)) > kRotated;
  if (far) remember(sweep);
  return X_PO;
}

void SweepAlignment::remember(const DetectionSet& sweep) {
  X_RO_ = {};
  sensor_ = sweep.sensor;
  angle_min_ = sweep.angle_min;
  angle_increment_ = sweep.angle_increment;
  ranges_.assign(sweep.free_ranges.begin(), sweep.free_ranges.end());
  no_return_ = longest(ranges_);
  directions_.resize(ranges_.size());
  for (std::size_t i = 0; i < ranges_.size(); ++i)
    directions_[i] = direction(angle_min_ + static_cast<double>(i) * angle_increment_);
}

}  // namespace bw::people
