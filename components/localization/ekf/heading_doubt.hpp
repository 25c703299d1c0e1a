// A compass that contradicts the estimate: is it disturbed, or is the estimate wrong, because the
// gyro that turned it failed?
//
// Two hypotheses, compared by their likelihood (a generalised likelihood ratio, Willsky and Jones 1976):
//   disturbed: the estimate is right;
//   right: the estimate errs by `error`, whose heading is the mean of its last innovations. Its position
//     grows as the robot drives, error <- F error, and every correction takes its part, error <- error - K H
//     error.
// Evidence comes from who is neither gyro nor compass:
//   wheels: D, the rotation by which they disagree with the gyro over a window, is 0 under the first and the
//     error of the heading under the second, with the variance of the wheels;
//   positions and whatever else corrects: an innovation is 0 under the first and H error under the second.
// So of gyro, wheels and compass the one that two others contradict is the one that failed, and where they
// leave it open the fixes tell. Until it is told the covariance covers both.
#pragma once

#include <algorithm>
#include <cmath>

#include "components/localization/ekf/correction.hpp"
#include "components/localization/ekf/ekf_options.hpp"
#include "components/localization/ekf/ekf_state.hpp"

namespace bw::localization {

/// Takes in a reading of a compass, before the correction. A doubt begins where the mean of its innovations is
/// beyond the gate `threshold`. True when the estimate is to be corrected by correct_heading().
bool doubt_heading(EkfState& state, int source, Time time, const Innovation<kStates, 1>& z, double threshold,
                   const EkfOptions& options);

/// Puts the estimate where the compass says, and leaves the gyro out for a while.
void correct_heading(EkfState& state, int source, Time time);

/// Second moment of (x, y, theta) about the estimate of the mixture of both hypotheses: P + p error error^T, p the
/// probability that the compass is right.
Eigen::Matrix3d mixture_covariance(const EkfState& state);

/// Evidence of a measurement that is no compass, `passes` the gate or not. Call it before the correction.
template <int N>
void weigh_doubt(HeadingDoubt& doubt, const Innovation<kStates, N>& z, const StateMatrix& P, double threshold,
                 bool passes) {
  constexpr double kMax = 10.0;  // no sum of evidence is surer than that
  const Eigen::Matrix<double, kStates, N> PHt = P * z.H.transpose();
  const Eigen::LLT<Eigen::Matrix<double, N, N>> S(z.H * PHt + z.R);
  const Eigen::Matrix<double, N, 1> expected = z.H * doubt.error;
  const Eigen::Matrix<double, N, 1> rest = z.residual - expected;
  const double as_it_is = z.residual.dot(S.solve(z.residual));
  const double corrected = rest.dot(S.solve(rest));
  // Beyond the gate it is an outlier to either, and how far says nothing.
  const double evidence = 0.5 * (std::min(as_it_is, threshold) - std::min(corrected, threshold));
  if (std::isfinite(evidence)) doubt.by_others = std::clamp(doubt.by_others + evidence, -kMax, kMax);
  if (passes) doubt.error -= PHt * S.solve(expected);
}

}  // namespace bw::localization
