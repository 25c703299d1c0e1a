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

/// P symmetric. (I - K H) P (I - K H)^T is taken from each side in turn, a product of rank M each.
template <int N, int M>
void update(Eigen::Matrix<double, N, 1>& x, Eigen::Matrix<double, N, N>& P, const Innovation<N, M>& z) {
  using Tall = Eigen::Matrix<double, N, M>;
  const Tall PHt = P.lazyProduct(z.H.transpose());
  const Eigen::Matrix<double, M, M> S = z.H.lazyProduct(PHt) + z.R;
  const Tall K = S.llt().solve(PHt.transpose()).transpose();
  x += K.lazyProduct(z.residual);
  P -= K.lazyProduct(PHt.transpose());
  const Tall rest = P.lazyProduct(z.H.transpose());
  P -= rest.lazyProduct(K.transpose());
  const Tall KR = K.lazyProduct(z.R);
  P += KR.lazyProduct(K.transpose());
  P = 0.5 * (P + P.transpose().eval());
}

}  // namespace bw::localization
