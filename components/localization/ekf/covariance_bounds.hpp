// What keeps a covariance one, whatever numbers came in: variances that say "unknown" stop growing, and
// rounding never takes the last of a variance away.
#pragma once

#include "components/localization/ekf/ekf_state.hpp"

namespace bw::localization {

/// Scales states whose variance has grown beyond (1 km)^2 or 10 rad^2 (rad^2/s^2) back to that; correlations
/// stay.
void limit_variances(StateMatrix& P);

/// Makes P symmetric and positive definite over the states that have a variance (an unused one has none), in
/// such a way that the least eigenvalue of its correlations C is at least 1e-9.
///  1. Cholesky P = L D L^T; a pivot D_j below its floor (1e-9 of P_jj, and 1e-13 of the variance before the
///     operation whose rounding is repaired) is raised to it, and P_jj by as much.
///  2. det C = product of D_j / P_jj; least eigenvalue >= det C / (n / (n - 1))^(n - 1), since the n
///     eigenvalues sum up to n. Where det C < 1e-8 does not promise enough, variances grow by 1e-9, which
///     moves every eigenvalue by that.
/// Variances never shrink.
void hold_definite(StateMatrix& P, const StateVector& variances_before);

}  // namespace bw::localization
