// How noisy a source really is, from its innovations: the factor on its declared covariance.
//
// Two innovations in a row, whitened by the declared covariance, of dimension N each, differ by a d with
//
//   E|d|^2 / 2 = factor N + trace(R^-1 H P H^T)
//
// What persists, an error of the estimate or of the source, cancels: that is for the gate and re-acquisition,
// not for a factor on the noise.
#pragma once

#include <algorithm>

#include <Eigen/Cholesky>

#include "components/localization/ekf/correction.hpp"
#include "components/localization/ekf/ekf_options.hpp"
#include "components/localization/ekf/ekf_state.hpp"

namespace bw::localization {

constexpr double kMaxSurprise = 6.0;  // an outlier counts as so many times the variance

/// Takes in an innovation with the declared R; the factor that holds for it, from those before.
template <int N>
double adapt_noise(NoiseWatch& watch, const Innovation<kStates, N>& z, const StateMatrix& P,
                   const AdaptiveOptions& options) {
  const Eigen::LLT<Eigen::Matrix<double, N, N>> R(z.R);
  const Eigen::Matrix<double, N, 1> white = R.matrixL().solve(z.residual);
  const double expected = R.solve(z.H * P * z.H.transpose()).trace() / N;
  const double factor = watch.factor;
  // Where the estimate is worse than the source, innovations tell of the estimate.
  if (watch.dof == N && expected < watch.factor) {
    const double change = (white - watch.last.template head<N>()).squaredNorm() / (2.0 * N);
    const double sample = std::min(change - expected, kMaxSurprise * factor);
    watch.factor = std::clamp(factor + (sample - factor) / options.kMemory, options.kFloor, options.kCeiling);
  }
  watch.last.template head<N>() = white;
  watch.dof = N;
  return std::clamp(factor, options.kFloor, options.kCeiling);
}

}  // namespace bw::localization
