#include "components/recordings/hold_out.hpp"

#include <utility>

namespace bw {

std::vector<FixSample> hold_out(RecordedDrive& drive, const HoldOutOptions& options) {
  std::vector<FixSample> given;
  std::vector<FixSample> held_out;
  const Duration period = Duration::seconds(options.period);
  for (std::size_t i = 0; i < drive.fixes.size(); ++i) {
    const FixSample& fix = drive.fixes[i];
    const double t = fix.time.to_seconds();
    bool held = false;
    switch (options.rule) {
      case HoldOutRule::none:
        break;
      case HoldOutRule::every_second:
        held = i % 2 == 1;
        break;
      case HoldOutRule::sparse:
        held = !given.empty() && fix.time - given.back().time < period;
        break;
      case HoldOutRule::outage:
        held = t >= options.from && t <= options.to;
        break;
    }
    (held ? held_out : given).push_back(fix);
  }
  drive.fixes = std::move(given);
  return held_out;
}

}  // namespace bw
