#include "components/localization/ekf/heading_doubt.hpp"

#include "components/localization/ekf/slip.hpp"

namespace bw::localization {
namespace {

constexpr double kNewest = 0.1;              // share of a new reading in the mean
constexpr int kFirstReadings = 10;           // before it counts
constexpr double kSettled = 0.25;            // of the gate at which a doubt begins
constexpr double kOnset = 2.0;               // [s] of a doubt in which wheels tell
constexpr double kLeastVariance = 1e-4;      // (0.01 rad)^2 that wheels never know a rotation better than
constexpr double kMostByWheels = 5.0;        // wheels slip
constexpr double kEnough = 3.0;              // log of the likelihood ratio: 20 to 1
constexpr double kShareOfCorrection = 0.25;  // of the square of a correction stays as variance
constexpr double kDistrust = 2.0;            // [s]

double clamped(double evidence) { return std::clamp(evidence, -kMostByWheels, kMostByWheels); }

}  // namespace

bool doubt_heading(EkfState& state, int source, Time time, const Innovation<kStates, 1>& z, double threshold,
                   const EkfOptions& options) {
  HeadingDoubt& doubt = state.doubt;
  if (doubt.source < 0) doubt.source = source;
  if (doubt.source != source) return false;
  const double share = std::max(1.0 / ++doubt.readings, kNewest);
  doubt.error(2) += share * wrap_angle(z.residual(0) - doubt.error(2));
  const double error = doubt.error(2);
  const double known = z.covariance(state.P)(0, 0) - z.R(0, 0);
  const double variance = known + z.R(0, 0) * share / (2.0 - share);
  const double excess = error * error / variance;
  if (!doubt.is_open()) {
    if (doubt.readings < kFirstReadings || !(excess > threshold)) return false;
    doubt.since = time;
  } else if (excess < kSettled * threshold) {
    const int readings = doubt.readings;
    doubt = {.source = source, .readings = readings};
    doubt.error(2) = error;
    return false;
  }
  if (gyro_in_doubt(state.slip, state.time, options.slip)) {
    doubt.by_wheels = 0.0;  // they turn the estimate
  } else if (time - doubt.since <= Duration::seconds(kOnset)) {
    const double spread = kLeastVariance + state.slip.apart_variance + variance;
    doubt.by_wheels = clamped(error * (2.0 * state.slip.apart - error) / (2.0 * spread));
  }
  return doubt.evidence() > kEnough;
}

void correct_heading(EkfState& state, int source, Time time) {
  const StateVector error = state.doubt.error;
  state.x += error;
  state.x(2) = wrap_angle(state.x(2));
  state.P += kShareOfCorrection * error * error.transpose();
  state.slip.distrusted_until = time + Duration::seconds(kDistrust);
  state.doubt = {};
  state.last_reset = time;
  state.reset_source = source;
}

Eigen::Matrix3d mixture_covariance(const EkfState& state) {
  const Eigen::Vector3d error = state.doubt.error.head<3>();
  return state.P.topLeftCorner<3, 3>() + state.doubt.probability() * error * error.transpose();
}

}  // namespace bw::localization
