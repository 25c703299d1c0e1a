#include "components/localization/ekf/slip.hpp"

#include <cmath>

namespace bw::localization {
namespace {
constexpr double kForgetting = 30.0;  // [s] over which slip is added up for the doubt
}

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
    if (!slipping(watch)) {
      watch.since = time;
      watch.way = watch.turn = 0.0;
    }
  } else if (slipping(watch) && time - watch.seen > Duration::seconds(options.hold)) {
    watch.since = kNever;
  }
  watch.lately *= std::exp(-difference.seconds / kForgetting);
  if (slipping(watch)) watch.lately += difference.seconds;
}

}  // namespace bw::localization
