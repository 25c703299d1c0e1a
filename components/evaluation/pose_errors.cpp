#include "components/evaluation/pose_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "components/model/differential_drive.hpp"

namespace bw {
namespace {

constexpr double kSameMoment = 0.2;        // [s]
constexpr double kLongestGap = 0.5;        // [s] between two truths
constexpr std::size_t kMaxWaiting = 1000;  // estimates, of a truth that is silent

double mean_root(double squares, int count) {
  return count > 0 ? std::sqrt(squares / count) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

void PoseErrors::set_truth(const TruthSample& truth) {
  if (truth_.X_MB.position().allFinite()) before_ = truth_;
  truth_ = truth;
  if (!has_speed()) {
    for (const Estimate& estimate : waiting_) compare_between(estimate);
  }
  waiting_.clear();
}

void PoseErrors::add(Time time, const Pose2& X_MB) {
  if (!truth_.X_MB.position().allFinite() || !is_finite(X_MB)) return;
  if (!has_speed()) {
    const Estimate estimate{time, X_MB};
    if (!compare_between(estimate) && waiting_.size() < kMaxWaiting) waiting_.push_back(estimate);
    return;
  }
  const double ahead = (time - truth_.time).to_seconds();
  if (std::abs(ahead) > kSameMoment) return;
  count(X_MB, advance_exact(truth_.X_MB, truth_.twist, ahead));
}

bool PoseErrors::compare_between(const Estimate& estimate) {
  if (estimate.time > truth_.time) return false;
  if (estimate.time == truth_.time) {
    count(estimate.X_MB, truth_.X_MB);
    return true;
  }
  if (!before_ || estimate.time < before_->time) return true;
  const double gap = (truth_.time - before_->time).to_seconds();
  if (gap > kLongestGap) return true;
  const double part = (estimate.time - before_->time).to_seconds() / gap;
  const Pose2& from = before_->X_MB;
  const Pose2& to = truth_.X_MB;
  count(estimate.X_MB, {from.x + part * (to.x - from.x), from.y + part * (to.y - from.y),
                        wrap_angle(from.theta + part * wrap_angle(to.theta - from.theta))});
  return true;
}

void PoseErrors::count(const Pose2& X_MB, const Pose2& true_X_MB) {
  const double distance = (X_MB.position() - true_X_MB.position()).norm();
  ++count_;
  sum_ += distance;
  squares_ += distance * distance;
  worst_ = std::max(worst_, distance);
  if (!std::isfinite(true_X_MB.theta)) return;
  const double heading = wrap_angle(X_MB.theta - true_X_MB.theta);
  ++heading_count_;
  heading_squares_ += heading * heading;
}

double PoseErrors::mean_position() const {
  return count_ > 0 ? sum_ / count_ : std::numeric_limits<double>::quiet_NaN();
}
double PoseErrors::rms_position() const { return mean_root(squares_, count_); }
double PoseErrors::rms_heading() const { return mean_root(heading_squares_, heading_count_); }
double PoseErrors::max_position() const {
  return count_ > 0 ? worst_ : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace bw
