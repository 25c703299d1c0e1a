// One correction of a Gaussian by a linear(ised) measurement, Joseph form: P stays symmetric and positive
// semi-definite under rounding, whatever the gain.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace bw::localization {

template <int N, int M>
struct Innovation {
  Eigen::Matrix<double, M, 1> residual;  ///< measured - predicted, angles wrapped
  Eigen::Matrix<double, M, N> H;         ///< d predicted / d state
  Eigen::Matrix<double, M, M> R;

  Eigen::Matrix<double, M, M> covariance(const Eigen::Matrix<double, N, N>& P) const {
    return H * P * H.transpose() + R;
  }
  /// Normalised innovation squared: chi-square of M degrees of freedom for an honest filter.
  double nis(const Eigen::Matrix<double, N, N>& P) const {
    return residual.dot(covariance(P).llt().solve(residual));
  }
};

template <int N, int M>
void update(Eigen::Matrix<double, N, 1>& x, Eigen::Matrix<double, N, N>& P, const Innovation<N, M>& z) {
  const Eigen::Matrix<double, M, M> S = z.covariance(P);
  const Eigen::Matrix<double, N, M> K = S.llt().solve(z.H * P).transpose();
  x += K * z.residual;
  Eigen::Matrix<double, N, N> A = Eigen::Matrix<double, N, N>::Identity();
  A.noalias() -= K * z.H;
  const Eigen::Matrix<double, N, N> corrected = A * P * A.transpose() + K * z.R * K.transpose();
  P = 0.5 * (corrected + corrected.transpose());
}

}  // namespace bw::localization
