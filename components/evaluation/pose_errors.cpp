#include "components/evaluation/pose_errors.hpp"

#include <algorithm>
#include <cmath>

#include "components/model/differential_drive.hpp"

namespace bw {
namespace {

constexpr double kSameMoment = 0.2;  // [s]

double mean_root(double squares, int count) {
  return count > 0 ? std::sqrt(squares / count) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

void PoseErrors::add(Time time, const Pose2& X_MB) {
  if (!is_finite(truth_.X_MB) || !is_finite(X_MB)) return;
  const double ahead = (time - truth_.time).to_seconds();
  if (std::abs(ahead) > kSameMoment) return;
  const Pose2 true_X_MB = advance_exact(truth_.X_MB, truth_.twist, ahead);
  const double distance = (X_MB.position() - true_X_MB.position()).norm();
  const double heading = wrap_angle(X_MB.theta - true_X_MB.theta);
  ++count_;
  squares_ += distance * distance;
  heading_squares_ += heading * heading;
  worst_ = std::max(worst_, distance);
}

double PoseErrors::rms_position() const { return mean_root(squares_, count_); }
double PoseErrors::rms_heading() const { return mean_root(heading_squares_, count_); }
double PoseErrors::max_position() const {
  return count_ > 0 ? worst_ : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace bw
