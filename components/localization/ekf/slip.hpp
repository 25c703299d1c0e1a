// Wheel slip from the turn that wheels and gyro disagree about.
//
// e <- lambda e + (turn - gyro), s <- lambda^2 s + var, T <- lambda T + dt, lambda = exp(-dt / window); slip
// when e^2 > gate (s + T^2 var(bias)) and |e| > least_rate T. One wheel that slips always shows; both alike
// show only while turning, so that slip lasts for `hold` after its last sign.
#pragma once

#include <cmath>

#include "components/localization/ekf/ekf_options.hpp"
#include "components/localization/ekf/ekf_state.hpp"

namespace bw::localization {

/// Disagreement of one step: `turn` [rad] of the wheels less the gyro's without bias, its white variance.
struct TurnDifference {
  double turn = 0.0;
  double variance = 0.0;
  double seconds = 0.0;
};

/// Takes in a step that ends at `time`.
void watch_slip(SlipWatch& watch, const TurnDifference& difference, double bias_variance, Time time,
                const SlipOptions& options);

/// Variance that a way of |step| [m or rad] adds when all of it errs alike, as a share of its length:
/// standard deviations add up, (share (sum + |step|))^2 - (share sum)^2. Adds |step| to `sum`.
inline double common_error(double& sum, double step, double share) {
  const double before = sum;
  sum += std::abs(step);
  return share * share * (sum * sum - before * before);
}

inline bool slipping(const SlipWatch& watch) { return watch.since != kNever; }

/// More slip lately than wheels slip: gyro or encoders are wrong, and nothing tells which.
inline bool gyro_in_doubt(const SlipWatch& watch, const SlipOptions& options) {
  return watch.lately > options.longest;
}

}  // namespace bw::localization
