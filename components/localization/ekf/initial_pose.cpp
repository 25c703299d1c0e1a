#include "components/localization/ekf/initial_pose.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "components/model/arc.hpp"
#include "components/model/chi_square.hpp"

namespace bw::localization {
namespace {

constexpr std::size_t kMaxPoses = 1024;
constexpr std::size_t kMaxFixes = 64;
constexpr std::size_t kMaxHeadings = 32;
constexpr double kCaution = 2.0;  // times the variance: agreeing samples may share an error
// Variance of the heading at the end of a straight path against that of the line fitted through all of it, as
// a share of what the wheels' rotation adds up along it (a random walk): integral of (3 x^2 - 2 x^3)^2 over
// 0..1.
constexpr double kRotationSinceFit = 13.0 / 35.0;

// Keeps the latest ones; the older half goes at once, so that adding is cheap on average.
template <class T>
void push(std::vector<T>& values, const T& value, std::size_t most) {
  if (values.size() == most) values.erase(values.begin(), values.begin() + static_cast<long>(most / 2));
  values.push_back(value);
}

// Index of the value with the least sum of distances to all.
template <class Distance>
std::size_t medoid(std::size_t count, const Distance& distance) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count; ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k < count; ++k) sum += distance(i, k);
    if (sum >= least) continue;
    least = sum;
    best = i;
  }
  return best;
}

}  // namespace

InitialPose::InitialPose(const InitialOptions& options, double gate_probability)
    : options_(options),
      gate1_(chi_square_quantile(gate_probability, 1)),
      gate2_(chi_square_quantile(gate_probability, 2)) {
  restart();
}

void InitialPose::restart() {
  poses_.assign(1, {kNever, {}});
  fixes_.clear();
  headings_.clear();
}

InitialPose::OdometryPose InitialPose::pose_at(Time time) const {
  const auto after = std::upper_bound(poses_.begin(), poses_.end(), time,
                                      [](Time t, const OdometryPose& pose) { return t < pose.time; });
  if (after == poses_.begin()) return *after;
  const OdometryPose& before = *(after - 1);
  if (after == poses_.end() || before.time == kNever) return before;
  const double part = (time - before.time).to_seconds() / (after->time - before.time).to_seconds();
  const Pose2 moved = inverse(before.X_OB) * after->X_OB;
  return {time, before.X_OB * Pose2{part * moved.x, part * moved.y, part * moved.theta},
          before.heading_variance + part * (after->heading_variance - before.heading_variance)};
}

std::optional<StartPose> InitialPose::add(const Measurement& measurement) {
  if (const auto* pose = std::get_if<PoseReading>(&measurement))
    return StartPose{pose->time, pose->X_MB, pose->covariance};
  if (const auto* step = std::get_if<WheelStep>(&measurement)) {
    const OdometryPose& last = poses_.back();
    if (step->time <= last.time) return std::nullopt;
    push(poses_,
         {step->time, advance_arc(last.X_OB, step->distance, step->rotation),
          last.heading_variance + step->covariance(1, 1)},
         kMaxPoses);
  } else if (const auto* heading = std::get_if<HeadingReading>(&measurement)) {
    const OdometryPose at = pose_at(heading->time);
    push(headings_, {wrap_angle(heading->heading - at.X_OB.theta), heading->variance, at.heading_variance},
         kMaxHeadings);
  } else if (const auto* fix = std::get_if<PositionFix>(&measurement)) {
    const OdometryPose at = pose_at(fix->time);
    const double variance = fix->covariance.diagonal().maxCoeff();
    push(fixes_, {at.X_OB * fix->antenna, fix->position, variance, at.heading_variance}, kMaxFixes);
  } else {
    return std::nullopt;
  }
  if (!has_fixes()) return std::nullopt;
  std::optional<StartPose> start;
  if (const std::optional<Angle> theta_MO = heading_from_compass()) {
    start = with_heading(*theta_MO);
    if (start) start->by_compass = true;
  } else if (!has_headings()) {
    start = from_path();
  }
  if (start) start->time = poses_.back().time == kNever ? stamp(measurement) : poses_.back().time;
  return start;
}

std::optional<InitialPose::Angle> InitialPose::heading_from_compass() const {
  if (!has_headings()) return std::nullopt;
  const auto apart = [this](std::size_t i, std::size_t k) {
    return std::abs(wrap_angle(headings_[i].value - headings_[k].value));
  };
  const std::size_t middle = medoid(headings_.size(), apart);
  int agreeing = 0;
  double sum = 0.0;
  double variance = 0.0;
  for (const Angle& heading : headings_) {
    const double away = wrap_angle(heading.value - headings_[middle].value);
    if (away * away > gate1_ * (heading.variance + headings_[middle].variance)) continue;
    ++agreeing;
    sum += away;
    variance = std::max(variance, heading.variance);
  }
  if (2 * agreeing <= static_cast<int>(headings_.size()) || agreeing < options_.kHeadings)
    return std::nullopt;
  // Not divided by their number: readings of a compass err alike.
  const double wheels = poses_.back().heading_variance - headings_[middle].heading_variance;
  return Angle{wrap_angle(headings_[middle].value + sum / agreeing), kCaution * variance + wheels, 0.0};
}

std::optional<StartPose> InitialPose::with_heading(const Angle& theta_MO) const {
  std::vector<Vector2> shifts;
  shifts.reserve(fixes_.size());
  for (const Fix& fix : fixes_) shifts.push_back(fix.p_M - rotate({0.0, 0.0, theta_MO.value}, fix.p_O));
  const std::size_t middle =
      medoid(shifts.size(), [&](std::size_t i, std::size_t k) { return (shifts[i] - shifts[k]).norm(); });
  const auto reach = [&](std::size_t i) {  // a wrong heading moves far fixes apart
    return fixes_[i].variance + theta_MO.variance * (fixes_[i].p_O - fixes_[middle].p_O).squaredNorm();
  };
  int agreeing = 0;
  double variance = 0.0;
  Vector2 shift{0.0, 0.0};
  Vector2 centre_O{0.0, 0.0};
  for (std::size_t i = 0; i < shifts.size(); ++i) {
    if ((shifts[i] - shifts[middle]).squaredNorm() > gate2_ * (reach(i) + reach(middle))) continue;
    ++agreeing;
    shift += shifts[i];
    centre_O += fixes_[i].p_O;
    variance = std::max(variance, fixes_[i].variance);
  }
  if (2 * agreeing <= static_cast<int>(shifts.size()) || agreeing < options_.kFixes) return std::nullopt;
  shift /= agreeing;
  centre_O /= agreeing;
  StartPose start;
  const Pose2 X_OB = poses_.back().X_OB;
  start.X_MB = Pose2{shift.x(), shift.y(), theta_MO.value} * X_OB;
  const Vector2 arm = rotate({0.0, 0.0, theta_MO.value}, X_OB.position() - centre_O);
  const Vector2 by_heading(-arm.y(), arm.x());
  Eigen::Matrix3d& C = start.covariance;
  C.topLeftCorner<2, 2>() = theta_MO.variance * by_heading * by_heading.transpose();
  C(0, 0) += kCaution * variance / agreeing;
  C(1, 1) += kCaution * variance / agreeing;
  C.topRightCorner<2, 1>() = theta_MO.variance * by_heading;
  C.bottomLeftCorner<1, 2>() = C.topRightCorner<2, 1>().transpose();
  C(2, 2) = theta_MO.variance;
  return start;
}

std::optional<StartPose> InitialPose::from_path() const {
  std::vector<Fix> fitting = fixes_;
  const std::size_t least = std::max<std::size_t>(4, fixes_.size() / 2 + 1);
  while (fitting.size() >= least) {
    RigidFit fit;
    double variance = 0.0;
    for (const Fix& f : fitting) {
      fit.add(f.p_M, f.p_O);
      variance = std::max(variance, f.variance);
    }
    const Pose2 X_MO = fit.X_AB();
    std::size_t worst = 0;
    double worst_distance = 0.0;
    double longest = 0.0;
    for (std::size_t i = 0; i < fitting.size(); ++i) {
      longest = std::max(longest, (fitting[i].p_O - fitting.front().p_O).norm());
      const double distance = (fitting[i].p_M - X_MO * fitting[i].p_O).squaredNorm() / fitting[i].variance;
      if (distance <= worst_distance) continue;
      worst_distance = distance;
      worst = i;
    }
    if (worst_distance > kCaution * gate2_) {
      fitting.erase(fitting.begin() + static_cast<long>(worst));
      continue;
    }
    const double spread = fit.spread();
    if (longest < options_.distance || spread <= 0.0) return std::nullopt;
    const double wheels =
        kRotationSinceFit * (poses_.back().heading_variance - fitting.front().heading_variance);
    const Angle theta_MO{X_MO.theta, kCaution * variance / spread + wheels, 0.0};
    if (theta_MO.variance > options_.heading_sigma * options_.heading_sigma) return std::nullopt;
    return with_heading(theta_MO);
  }
  return std::nullopt;
}

}  // namespace bw::localization
