#include "components/localization/measurement_check.hpp"

#include <cmath>

#include <Eigen/Cholesky>

namespace bw::localization {
namespace {

constexpr double kAsymmetry = 1e-6;  // of a correlation; messages round their numbers

// Both triangles' mean over the standard deviations, so that axes of very different size weigh alike. Must
// have a positive diagonal.
template <int N>
Eigen::Matrix<double, N, N> correlations(const Eigen::Matrix<double, N, N>& C) {
  const Eigen::Matrix<double, N, 1> scale = C.diagonal().cwiseSqrt().cwiseInverse();
  return 0.5 * scale.asDiagonal() * (C + C.transpose()) * scale.asDiagonal();
}

template <int N>
bool is_symmetric(const Eigen::Matrix<double, N, N>& C) {
  for (int i = 0; i < N; ++i)
    for (int k = 0; k < i; ++k)
      if (std::abs(C(i, k) - C(k, i)) > kAsymmetry * std::sqrt(C(i, i)) * std::sqrt(C(k, k))) return false;
  return true;
}

template <int N>
Verdict check_covariance(const Eigen::Matrix<double, N, N>& C, double limit) {
  if (!C.allFinite()) return Verdict::not_finite;
  const double largest = C.diagonal().maxCoeff();
  if (C.diagonal().minCoeff() <= 0.0 || largest > limit) return Verdict::bad_covariance;
  if (!is_symmetric<N>(C)) return Verdict::bad_covariance;
  const Eigen::LLT<Eigen::Matrix<double, N, N>> cholesky(correlations<N>(C));
  return cholesky.info() == Eigen::Success ? Verdict::accepted : Verdict::bad_covariance;
}

Verdict check_variance(double variance, double limit) {
  if (!std::isfinite(variance)) return Verdict::not_finite;
  return variance > 0.0 && variance <= limit ? Verdict::accepted : Verdict::bad_covariance;
}

bool is_angle(double angle) {
  return std::abs(angle) <= 1e3;
}  // beyond, the wrapped rest has lost its digits

struct Checker {
  const MeasurementLimits& limits;

  Verdict operator()(const GyroReading& m) const {
    if (!std::isfinite(m.rate)) return Verdict::not_finite;
    if (std::abs(m.rate) > limits.turn_rate) return Verdict::implausible;
    return check_variance(m.variance, limits.variance);
  }

  Verdict operator()(const WheelStep& m) const {
    const bool finite = std::isfinite(m.distance) && std::isfinite(m.rotation) && m.covariance.allFinite() &&
                        std::isfinite(m.separation) && std::isfinite(m.rounding);
    if (!finite) return Verdict::not_finite;
    const double seconds = m.over.to_seconds();
    if (m.over.nanoseconds <= 0 || seconds > limits.wheel_interval) return Verdict::bad_interval;
    if (m.separation < 0.0 || m.separation > 100.0) return Verdict::implausible;
    if (std::abs(m.distance) > limits.speed * seconds || std::abs(m.rotation) > limits.turn_rate * seconds)
      return Verdict::implausible;
    // A standing base has zero covariance: semi-definite will do.
    const Eigen::Matrix2d& C = m.covariance;
    const double largest = C.diagonal().maxCoeff();
    if (C.diagonal().minCoeff() < 0.0 || largest > limits.variance) return Verdict::bad_covariance;
    if (m.rounding < 0.0 || m.rounding > limits.variance) return Verdict::bad_covariance;
    const double most = std::sqrt(C(0, 0)) * std::sqrt(C(1, 1));
    const bool sound = is_symmetric<2>(C) && std::abs(C(0, 1) + C(1, 0)) <= 2.0 * most * (1.0 + 1e-9);
    return sound ? Verdict::accepted : Verdict::bad_covariance;
  }

  Verdict operator()(const PoseReading& m) const {
    if (!is_finite(m.X_MB)) return Verdict::not_finite;
    if (!within(m.X_MB.position()) || !is_angle(m.X_MB.theta)) return Verdict::implausible;
    return check_covariance<3>(m.covariance, limits.variance);
  }

  Verdict operator()(const PositionFix& m) const {
    if (!m.position.allFinite() || !m.antenna.allFinite()) return Verdict::not_finite;
    if (!within(m.position) || m.antenna.norm() > 100.0) return Verdict::implausible;
    return check_covariance<2>(m.covariance, limits.variance);
  }

  Verdict operator()(const RangeReading& m) const {
    if (!std::isfinite(m.range) || !m.anchor.allFinite() || !m.antenna.allFinite())
      return Verdict::not_finite;
    const bool plausible =
        m.range >= 0.0 && m.range <= limits.distance && within(m.anchor) && m.antenna.norm() <= 100.0;
    if (!plausible) return Verdict::implausible;
    return check_variance(m.variance, limits.variance);
  }

  Verdict operator()(const HeadingReading& m) const { return check_direction(m.heading, m.variance); }
  Verdict operator()(const CourseReading& m) const { return check_direction(m.course, m.variance); }

  Verdict check_direction(double angle, double variance) const {
    if (!std::isfinite(angle)) return Verdict::not_finite;
    if (!is_angle(angle)) return Verdict::implausible;
    return check_variance(variance, limits.variance);
  }

  bool within(const Vector2& p) const { return p.cwiseAbs().maxCoeff() <= limits.distance; }
};

}  // namespace

Verdict check(const Measurement& measurement, const MeasurementLimits& limits, int sources) {
  const int from = source(measurement);
  if (from < 0 || from >= sources) return Verdict::bad_source;
  return std::visit(Checker{limits}, measurement);
}

}  // namespace bw::localization
