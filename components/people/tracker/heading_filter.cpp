#include "components/people/tracker/heading_filter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>

namespace bw::people {
namespace {

constexpr double kSurpriseMemory = 0.5;  // [s]
// Share of the velocity's covariance that is its error where innovations are as foreseen, measured: NEES 2.
constexpr double kTrueShare = 0.7;
constexpr double kLeastShare = 0.02;

}  // namespace

HeadingFilter::HeadingFilter(const Eigen::Vector4d& motion, const Eigen::Matrix4d& covariance,
                             const HeadingOptions& options) {
  x_ = motion;
  P_ = covariance;
  choose_form(options);
}

HeadingFilter::HeadingFilter(const SeenPosition& first, const SeenPosition& second, double dt,
                             const HeadingOptions& options) {
  x_.head<2>() = second.position;
  x_.segment<2>(2) = (second.position - first.position) / dt;
  P_.topLeftCorner<2, 2>() = second.covariance;
  P_.block<2, 2>(0, 2) = P_.block<2, 2>(2, 0) = second.covariance / dt;
  // The velocity at the end differs from the mean one by the acceleration between.
  const double q = options.acceleration * options.acceleration;
  P_.block<2, 2>(2, 2) =
      (first.covariance + second.covariance) / (dt * dt) + q * dt / 3.0 * Eigen::Matrix2d::Identity();
  choose_form(options);
}

void HeadingFilter::predict(double dt, const HeadingOptions& options) {
  if (dt <= 0.0) return;
  since_ += dt;
  if (!walks_) {
    const Eigen::Matrix4d F = glide(dt);
    x_ = (F * x_).eval();
    P_ = (F * P_ * F.transpose() + glide_noise(dt, options.acceleration_standing)).eval();
    return;
  }
  const HeadingCovariance F = walked_jacobian(x_, dt);
  P_ = (F * P_ * F.transpose() + walked_noise(x_, dt, {options.heading_noise, options.acceleration})).eval();
  x_ = walked(x_, dt);
}

void HeadingFilter::correct(const SeenPosition& seen, const HeadingOptions& options) {
  const Eigen::Matrix2d S = P_.topLeftCorner<2, 2>() + seen.covariance;
  const Eigen::Matrix<double, 4, 2> PHt = P_.leftCols<2>();
  const Eigen::Matrix<double, 4, 2> K = S.ldlt().solve(PHt.transpose()).transpose();
  const Vector2 innovation = seen.position - position();
  surprise_ += std::min(1.0, since_ / kSurpriseMemory) *
               (innovation.dot(S.ldlt().solve(innovation)) / 2.0 - surprise_);
  since_ = 0.0;
  x_ += K * innovation;
  // Joseph form, expanded: P - K (PH')' - (PH') K' + K S K'.
  const HeadingCovariance KHP = K * PHt.transpose();
  P_ += K * S * K.transpose() - KHP - KHP.transpose();
  P_ = (0.5 * (P_ + P_.transpose())).eval();
  choose_form(options);
}

void HeadingFilter::choose_form(const HeadingOptions& options) {
  const double speed = velocity().norm();
  if (!walks_ && speed >= options.walking_speed) {
    const HeadingCovariance J = with_heading_jacobian(x_);
    P_ = (J * P_ * J.transpose()).eval();
    x_ = with_heading(x_);
    walks_ = true;
  } else if (walks_ && speed < options.walking_speed) {
    P_ = covariance();
    x_ = without_heading(x_);
    walks_ = false;
  } else if (walks_ && x_[3] < 0.0) {  // backwards is forwards the other way round
    x_[3] = -x_[3];
    x_[2] += std::numbers::pi;
    P_.row(3) *= -1.0;
    P_.col(3) *= -1.0;
  }
  if (walks_) x_[2] = wrap_angle(x_[2]);
}

Vector2 HeadingFilter::velocity() const {
  return walks_ ? Vector2(x_[3] * direction(x_[2])) : Vector2(x_.segment<2>(2));
}

Eigen::Matrix4d HeadingFilter::covariance() const { return walks_ ? covariance_without_heading(x_, P_) : P_; }

Eigen::Matrix4d HeadingFilter::true_covariance() const {
  const double unseen = std::min(1.0, since_ / kSurpriseMemory);  // nobody looks: as it is foreseen
  const double scale = std::clamp(kTrueShare * std::lerp(surprise_, 1.0, unseen), kLeastShare, 1.0);
  Eigen::Matrix4d C = covariance();
  C.bottomRightCorner<2, 2>() *= scale;
  C.topRightCorner<2, 2>() *= std::sqrt(scale);
  C.bottomLeftCorner<2, 2>() *= std::sqrt(scale);
  return C;
}

}  // namespace bw::people
