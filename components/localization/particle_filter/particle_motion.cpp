#include "components/localization/particle_filter/particle_motion.hpp"

#include <cmath>

#include "components/localization/particle_filter/vector_clones.hpp"
#include "components/localization/particle_filter/vector_math.hpp"

namespace bw::localization {
namespace {

struct Step {
  double x, y, theta;
  double xx, yx, yy, tx, ty, tt;  // rows of L
};

BW_VECTOR_CLONES
void move_all(double* __restrict x, double* __restrict y, double* __restrict theta,
              const float* __restrict n0, const float* __restrict n1, const float* __restrict n2,
              std::size_t count, Step m) {
  for (std::size_t i = 0; i < count; ++i) {
    const double a = n0[i];
    const double b = n1[i];
    const double c = n2[i];
    const double dx = m.x + m.xx * a;
    const double dy = m.y + m.yx * a + m.yy * b;
    const double rotation = m.theta + m.tx * a + m.ty * b + m.tt * c;
    const SinCos t = sin_cos(static_cast<float>(theta[i]));
    x[i] += t.cos * dx - t.sin * dy;
    y[i] += t.sin * dx + t.cos * dy;
    theta[i] = fast_wrap(theta[i] + rotation);
  }
}

}  // namespace

Eigen::Matrix3d square_root(const Eigen::Matrix3d& C) {
  Eigen::Matrix3d L = Eigen::Matrix3d::Zero();
  for (int j = 0; j < 3; ++j) {
    const double pivot = C(j, j) - L.row(j).head(j).squaredNorm();
    if (pivot <= 1e-12 * C(j, j)) continue;
    L(j, j) = std::sqrt(pivot);
    for (int i = j + 1; i < 3; ++i) L(i, j) = (C(i, j) - L.row(i).head(j).dot(L.row(j).head(j))) / L(j, j);
  }
  return L;
}

void ParticleMotion::move(ParticleSet& p, const UncertainMotion& motion) {
  const std::size_t padded = (p.size() + 31) / 32 * 32;
  random_.normals(normals_, 3 * padded);
  const Eigen::Matrix3d L = square_root(motion.covariance);
  const float* n = normals_.data();
  move_all(p.x.data(), p.y.data(), p.theta.data(), n, n + padded, n + 2 * padded, p.size(),
           {motion.X_BB.x, motion.X_BB.y, motion.X_BB.theta, L(0, 0), L(1, 0), L(1, 1), L(2, 0), L(2, 1),
            L(2, 2)});
}

void ParticleMotion::scatter(ParticleSet& p, std::size_t first, std::size_t count, const Pose2& mean,
                             const Eigen::Matrix3d& covariance) {
  const Eigen::Matrix3d L = square_root(covariance);
  random_.normals(normals_, 3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d n(normals_[3 * i], normals_[3 * i + 1], normals_[3 * i + 2]);
    const Eigen::Vector3d d = L * n;
    p.x[first + i] = mean.x + d.x();
    p.y[first + i] = mean.y + d.y();
    p.theta[first + i] = wrap_angle(mean.theta + d.z());
  }
}

}  // namespace bw::localization
