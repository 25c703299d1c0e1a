#include "components/people/detector/beams.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bw::people {

SweepFault fault_for_people(const LaserSweep& sweep) {
  constexpr double kMostIncrement = 0.2;  // [rad]
  if (const SweepFault fault = fault_of(sweep); fault != SweepFault::none) return fault;
  if (std::abs(sweep.angle_increment) > kMostIncrement) return SweepFault::bad_angles;
  const bool blind = std::all_of(sweep.ranges.begin(), sweep.ranges.end(),
                                 [&](float range) { return kind_of(range, sweep) == BeamKind::unknown; });
  return blind ? SweepFault::mostly_unknown : SweepFault::none;
}

void read_beams(const LaserSweep& sweep, Beams& beams) {
  const std::size_t count = sweep.ranges.size();
  const bool backwards = sweep.angle_increment < 0.0;
  const double last = static_cast<double>(count - 1);
  beams.angle_increment = std::abs(sweep.angle_increment);
  beams.angle_min = sweep.X_FL.theta + sweep.angle_min + (backwards ? last * sweep.angle_increment : 0.0);
  beams.closed = (last + 1.5) * beams.angle_increment >= 2.0 * std::numbers::pi;
  beams.sensor = sweep.X_FL.position();
  beams.kinds.assign(count, BeamKind::unknown);
  beams.ranges.assign(count, 0.0F);
  beams.points.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const float range = sweep.ranges[backwards ? count - 1 - i : i];
    beams.kinds[i] = kind_of(range, sweep);
    if (beams.kinds[i] == BeamKind::free) {
      beams.ranges[i] = static_cast<float>(sweep.range_max);
    } else if (beams.kinds[i] == BeamKind::hit) {
      beams.ranges[i] = range;
      const double angle = beams.angle_min + static_cast<double>(i) * beams.angle_increment;
      beams.points[i] = beams.sensor + static_cast<double>(range) * direction(angle);
    }
  }
}

}  // namespace bw::people
