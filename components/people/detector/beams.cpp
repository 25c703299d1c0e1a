#include "components/people/detector/beams.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace bw::people {

SweepFault fault_for_people(const LaserSweep& sweep) {
  constexpr double kMaxIncrement = 0.2;  // [rad]
  if (const SweepFault fault = fault_of(sweep); fault != SweepFault::none) return fault;
  if (std::abs(sweep.angle_increment) > kMaxIncrement) return SweepFault::bad_angles;
  const bool blind = std::all_of(sweep.ranges.begin(), sweep.ranges.end(),
                                 [&](float range) { return kind_of(range, sweep) == BeamKind::unknown; });
  return blind ? SweepFault::mostly_unknown : SweepFault::none;
}

namespace {

/// Where each beam looked, when the scanner moved meanwhile: the directions are then as even as the turning
/// was.
void place_moving(const LaserSweep& sweep, Beams& beams) {
  const bool backwards = sweep.angle_increment < 0.0;
  const std::size_t count = sweep.ranges.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t beam = backwards ? count - 1 - i : i;
    if (beams.kinds[i] != BeamKind::hit) continue;
    const double angle = sweep.angle_min + static_cast<double>(beam) * sweep.angle_increment;
    beams.points[i] =
        scanner_at(sweep, beam) * Vector2(static_cast<double>(beams.ranges[i]) * direction(angle));
  }
  const auto [first, last] = std::pair(scanner_at(sweep, 0).theta, scanner_at(sweep, count - 1).theta);
  const double rotation = wrap_angle(last - first);
  const double width = std::abs(sweep.angle_increment) * static_cast<double>(count - 1);
  beams.angle_min = backwards ? last + sweep.angle_min - width : first + sweep.angle_min;
  beams.angle_increment = (width + (backwards ? -rotation : rotation)) / static_cast<double>(count - 1);
}

}  // namespace

void read_beams(const LaserSweep& sweep, Beams& beams) {
  const std::size_t count = sweep.ranges.size();
  const bool backwards = sweep.angle_increment < 0.0;
  const double last = static_cast<double>(count - 1);
  beams.angle_increment = std::abs(sweep.angle_increment);
  beams.time_increment = backwards ? -sweep.time_increment : sweep.time_increment;
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
  if (!sweep.beam_poses.empty()) place_moving(sweep, beams);
}

}  // namespace bw::people
