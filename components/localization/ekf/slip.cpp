#include "components/localization/ekf/slip.hpp"

#include <cmath>

namespace bw::localization {

void watch_slip(SlipWatch& watch, const TurnDifference& difference, double bias_variance, Time time,
                const SlipOptions& options) {
  const double lambda = std::exp(-difference.seconds / options.window);
  watch.disagreement = lambda * watch.disagreement + difference.turn;
  watch.variance = lambda * lambda * watch.variance + difference.variance;
  watch.time = lambda * watch.time + difference.seconds;
  const double e = watch.disagreement;
  const double variance = watch.variance + watch.time * watch.time * bias_variance;
  const bool sign = e * e > options.gate * variance && std::abs(e) > options.least_rate * watch.time;
  if (sign) {
    watch.seen = time;
    if (!slipping(watch)) watch.since = time;
  } else if (slipping(watch) && time - watch.seen > Duration::seconds(options.hold)) {
    watch.since = kNever;
  }
}

bool gyro_in_doubt(const SlipWatch& watch, Time time, const SlipOptions& options) {
  return slipping(watch) && time - watch.since > Duration::seconds(options.longest);
}

}  // namespace bw::localization
