#include "components/localization/particle_filter/comparison.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/LU>

#include "components/localization/particle_filter/vector_clones.hpp"
#include "components/localization/particle_filter/vector_math.hpp"

namespace bw::localization {
namespace {

constexpr double kPrintedExponent = 0.4;

BW_VECTOR_CLONES
void point_differences(const double* __restrict x, const double* __restrict y, const double* __restrict theta,
                       std::size_t count, double px, double py, double zx, double zy, double* __restrict dx,
                       double* __restrict dy) {
  for (std::size_t i = 0; i < count; ++i) {
    const SinCos t = sin_cos(static_cast<float>(theta[i]));
    dx[i] = zx - (x[i] + (t.cos * px - t.sin * py));
    dy[i] = zy - (y[i] + (t.sin * px + t.cos * py));
  }
}

BW_VECTOR_CLONES
void angle_differences(const double* __restrict theta, std::size_t count, double z, double* __restrict d) {
  for (std::size_t i = 0; i < count; ++i) d[i] = fast_wrap(z - theta[i]);
}

// log_weight -= d^T W d / 2 with W symmetric, six numbers.
BW_VECTOR_CLONES
void add_gaussian(const double* __restrict a, const double* __restrict b, const double* __restrict c,
                  std::size_t count, const double* W, double* __restrict log_weight) {
  for (std::size_t i = 0; i < count; ++i) {
    const double squares = W[0] * a[i] * a[i] + W[1] * b[i] * b[i] + W[2] * c[i] * c[i];
    const double products = W[3] * a[i] * b[i] + W[4] * a[i] * c[i] + W[5] * b[i] * c[i];
    log_weight[i] -= 0.5 * squares + products;
  }
}

}  // namespace

Comparison compare_at(const PositionFix& fix, const Pose2& X_BS, bool) {
  Comparison c;
  c.point = X_BS * fix.antenna;
  c.position = fix.position;
  c.size = 2;
  c.R.topLeftCorner<2, 2>() = fix.covariance;
  return c;
}

Comparison compare_at(const PoseReading& reading, const Pose2& X_BS, bool) {
  Comparison c;
  c.point = X_BS.position();
  c.position = reading.X_MB.position();
  c.heading = reading.X_MB.theta - X_BS.theta;
  c.size = 3;
  c.R = reading.covariance;
  return c;
}

Comparison compare_at(const RangeReading& reading, const Pose2& X_BS, bool) {
  Comparison c;
  c.point = X_BS * reading.antenna;
  c.range = reading.range;
  c.anchor = reading.anchor;
  c.size = 1;
  c.R(0, 0) = reading.variance;
  return c;
}

Comparison compare_at(const HeadingReading& reading, const Pose2& X_BS, bool) {
  Comparison c;
  c.heading = reading.heading - X_BS.theta;
  c.size = 1;
  c.R(0, 0) = reading.variance;
  return c;
}

Comparison compare_at(const CourseReading& reading, const Pose2& X_BS, bool backward) {
  Comparison c;
  c.heading = reading.course - X_BS.theta + (backward ? std::numbers::pi : 0.0);
  c.size = 1;
  c.R(0, 0) = reading.variance;
  return c;
}

void differences(const Comparison& c, const ParticleSet& p, Differences& d) {
  const std::size_t n = p.size();
  d.size = 0;
  d.heading = -1;
  for (std::vector<double>& column : d.column) column.resize(n);
  const Vector2& q = c.point;
  if (c.position) {
    point_differences(p.x.data(), p.y.data(), p.theta.data(), n, q.x(), q.y(), c.position->x(),
                      c.position->y(), d.column[0].data(), d.column[1].data());
    d.size = 2;
  } else if (c.range) {
    point_differences(p.x.data(), p.y.data(), p.theta.data(), n, q.x(), q.y(), c.anchor.x(), c.anchor.y(),
                      d.column[0].data(), d.column[1].data());
    for (std::size_t i = 0; i < n; ++i)
      d.column[0][i] = *c.range - std::hypot(d.column[0][i], d.column[1][i]);
    d.size = 1;
  }
  if (!c.heading) return;
  d.heading = d.size;
  angle_differences(p.theta.data(), n, *c.heading, d.column[d.size++].data());
}

double normalised_innovation(const Comparison& c, const ParticleSet& p, const Differences& d) {
  const std::size_t n = p.size();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (int k = 0; k < d.size; ++k) {
    const double* r = d.column[k].data();
    if (k == d.heading) {  // a plain mean of angles would take pi and -pi for zero
      double sine = 0.0;
      double cosine = 0.0;
      for (std::size_t i = 0; i < n; ++i) {
        const SinCos t = sin_cos(static_cast<float>(r[i]));
        sine += p.weight[i] * t.sin;
        cosine += p.weight[i] * t.cos;
      }
      mean(k) = std::atan2(sine, cosine);
    } else {
      double sum = 0.0;
      for (std::size_t i = 0; i < n; ++i) sum += p.weight[i] * r[i];
      mean(k) = sum;
    }
  }
  Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < n; ++i) {
    Eigen::Vector3d away = Eigen::Vector3d::Zero();
    for (int k = 0; k < d.size; ++k) {
      away(k) = d.column[k][i] - mean(k);
      if (k == d.heading) away(k) = fast_wrap(away(k));
    }
    S.noalias() += p.weight[i] * away * away.transpose();
  }
  S += c.R;
  for (int k = d.size; k < 3; ++k) {
    S.row(k).setZero();
    S.col(k).setZero();
    S(k, k) = 1.0;
  }
  return mean.dot(S.inverse() * mean);
}

void add_log_weights(const Comparison& c, const Differences& d, WeightLaw law,
                     std::vector<double>& log_weight) {
  const std::size_t n = log_weight.size();
  Eigen::Matrix3d R = c.R;
  for (int k = d.size; k < 3; ++k) {
    R.row(k).setZero();
    R.col(k).setZero();
    R(k, k) = 1.0;
  }
  Eigen::Matrix3d W = law == WeightLaw::printed_unscaled ? Eigen::Matrix3d::Identity() : R.inverse().eval();
  for (int k = d.size; k < 3; ++k) W(k, k) = 0.0;
  const double packed[6] = {W(0, 0), W(1, 1), W(2, 2), W(0, 1), W(0, 2), W(1, 2)};
  const double* column[3];
  for (int k = 0; k < 3; ++k) column[k] = d.column[k < d.size ? k : 0].data();
  if (law == WeightLaw::gaussian) {
    add_gaussian(column[0], column[1], column[2], n, packed, log_weight.data());
    return;
  }
  for (std::size_t i = 0; i < n; ++i) {
    double half_square = 0.0;
    add_gaussian(column[0] + i, column[1] + i, column[2] + i, 1, packed, &half_square);
    log_weight[i] -= 0.5 * std::pow(-2.0 * half_square, kPrintedExponent / 2.0);
  }
}

}  // namespace bw::localization
