// Wheel slip from the rotation that wheels and gyro disagree about, and the distance that went with it.
//
// Sign of slip: e <- lambda e + (rotation - gyro), s <- lambda^2 s + var, T <- lambda T + dt, lambda =
// exp(-dt / window); slip when e^2 > gate (s + T^2 var(bias) + 2 rounding) and |e| > least_rate T. One wheel
// that slips always shows; both alike show only while rotating, so that slip lasts for `hold` after its last
// sign.
//
// The distance: with E the rotation that the wheels measured too much since the slip began, and b their
// separation,
//   right wheel alone at fault: b/2 E too far,      left wheel alone: -b/2 E too far,
//   both slip by the same share: travel / rotation * E too far (both measure the same circle, faster).
// A base keeps its speed better than a slipping wheel: each of the three is weighed by how well the speed
// that it leaves agrees with that before the slip, and the mean of what they say is taken back; their scatter
// stays as variance of the distance. Where none fits, all of the distance may be wrong.
#pragma once

#include <cmath>

#include "components/localization/ekf/ekf_options.hpp"
#include "components/localization/ekf/ekf_state.hpp"

namespace bw::localization {

/// One step as wheels measure it, and how far the gyro disagrees.
struct ComparedStep {
  double disagreement = 0.0;  ///< rotation of the wheels less the gyro's without bias [rad]
  double variance = 0.0;      ///< its white part [rad^2]
  double rounding = 0.0;      ///< what counts add at either end of any span, not of each step [rad^2]
  double seconds = 0.0;
  double distance = 0.0;    ///< [m]
  double rotation = 0.0;    ///< [rad]
  double separation = 0.0;  ///< of the wheels [m]; 0: unknown
};

/// Takes in a step that ends at `time`. `acceleration` [m/s^2]: standard deviation of the base's.
void watch_slip(SlipWatch& watch, const ComparedStep& step, double bias_variance, Time time,
                double acceleration, const SlipOptions& options);

/// To take off a step's distance while slipping() [m].
struct SlipCorrection {
  double of_step = 0.0;   ///< what this step measured too much
  double catch_up = 0.0;  ///< the same of earlier ones, as known by now
  double variance = 0.0;  ///< to add [m^2]
};
/// Of a step that watch_slip has taken in.
SlipCorrection take_back(SlipWatch& watch, const ComparedStep& step, Time time, const SlipOptions& options);

/// Variance that a rotation of |step| [rad] adds when all of it errs alike, as a share of its length:
/// standard deviations add up, (share (sum + |step|))^2 - (share sum)^2. Adds |step| to `sum`.
inline double common_error(double& sum, double step, double share) {
  const double before = sum;
  sum += std::abs(step);
  return share * share * (sum * sum - before * before);
}

inline bool slipping(const SlipWatch& watch) { return watch.since != kNever; }

/// More slip lately than wheels slip: gyro or encoders are wrong, and nothing tells which; or it was found to
/// have failed.
inline bool gyro_in_doubt(const SlipWatch& watch, Time time, const SlipOptions& options) {
  return watch.lately > options.longest || time < watch.distrusted_until;
}

}  // namespace bw::localization
