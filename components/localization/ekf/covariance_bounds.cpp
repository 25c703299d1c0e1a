#include "components/localization/ekf/covariance_bounds.hpp"

#include <algorithm>
#include <cmath>

namespace bw::localization {
namespace {

constexpr double kMaxVariances[kStates] = {1e6, 1e6, 10.0, 10.0, 10.0, 10.0};
constexpr double kLeastShare = 1e-9;  // 3 cm of 1 km
constexpr double kPromising = 1e-8;   // det C that keeps the least eigenvalue above 4e-9, n = 6
constexpr double kRoundOff = 1e-13;   // some hundred roundings of one operation

}  // namespace

void limit_variances(StateMatrix& P) {
  for (int i = 0; i < kStates; ++i) {
    if (P(i, i) <= kMaxVariances[i]) continue;
    const double scale = std::sqrt(kMaxVariances[i] / P(i, i));
    P.row(i) *= scale;
    P.col(i) *= scale;
  }
}

void hold_definite(StateMatrix& P, const StateVector& variances_before) {
  P = 0.5 * (P + P.transpose().eval());
  StateMatrix L;  // unit lower triangle, of P = L D L^T
  StateVector D;
  double determinant = 1.0;  // of the correlations
  for (int j = 0; j < kStates; ++j) {
    double pivot = P(j, j);
    for (int k = 0; k < j; ++k) pivot -= L(j, k) * L(j, k) * D(k);
    const double floor = std::max(kLeastShare * P(j, j), kRoundOff * variances_before(j));
    if (pivot < floor) {
      P(j, j) += floor - pivot;
      pivot = floor;
    }
    D(j) = pivot;
    if (P(j, j) > 0.0) determinant *= pivot / P(j, j);
    const double inverse = pivot > 1e-290 ? 1.0 / pivot : 0.0;  // unused, or as good as known
    for (int i = j + 1; i < kStates; ++i) {
      double rest = P(i, j);
      for (int k = 0; k < j; ++k) rest -= L(i, k) * L(j, k) * D(k);
      L(i, j) = rest * inverse;
    }
  }
  if (determinant < kPromising) P.diagonal() *= 1.0 + kLeastShare;
}

}  // namespace bw::localization
