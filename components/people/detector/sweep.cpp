#include "components/people/detector/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bw::people {
namespace {

constexpr std::size_t kMostBeams = 20'000;
constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kLeastIncrement = 1e-5;  // [rad]
constexpr double kMostIncrement = 0.2;    // [rad]: coarser shows no leg beyond half a metre
constexpr double kFarthest = 1e4;         // [m]

BeamKind kind_of(float range, const Sweep& sweep) {
  if (std::isinf(range) && range > 0.0F) return BeamKind::free;
  if (range > 0.0F && range >= sweep.range_min && range <= sweep.range_max) return BeamKind::hit;
  return BeamKind::unknown;
}

}  // namespace

const char* to_text(SweepFault fault) {
  switch (fault) {
    case SweepFault::none:
      return "sound";
    case SweepFault::no_beams:
      return "it holds no beams";
    case SweepFault::too_many_beams:
      return "it holds more beams than any scanner has";
    case SweepFault::bad_angles:
      return "its angles are not finite, stand still or go round more than once";
    case SweepFault::bad_limits:
      return "its least and largest range are no interval";
    case SweepFault::bad_pose:
      return "its pose is not finite";
    case SweepFault::no_reading:
      return "none of its beams says anything";
  }
  return "unknown";
}

SweepFault fault_of(const Sweep& sweep) {
  if (sweep.ranges.empty()) return SweepFault::no_beams;
  if (sweep.ranges.size() > kMostBeams) return SweepFault::too_many_beams;
  const double step = std::abs(sweep.angle_increment);
  const double steps = static_cast<double>(sweep.ranges.size() - 1);
  if (!(std::abs(sweep.angle_min) <= 2.0 * kTurn) || !(step >= kLeastIncrement && step <= kMostIncrement) ||
      steps * step > kTurn + 1e-3)
    return SweepFault::bad_angles;
  if (!(sweep.range_min >= 0.0 && sweep.range_max > sweep.range_min && sweep.range_max <= kFarthest))
    return SweepFault::bad_limits;
  if (!is_finite(sweep.X_OL)) return SweepFault::bad_pose;
  const bool blind = std::all_of(sweep.ranges.begin(), sweep.ranges.end(),
                                 [&](float range) { return kind_of(range, sweep) == BeamKind::unknown; });
  return blind ? SweepFault::no_reading : SweepFault::none;
}

void read_beams(const Sweep& sweep, Beams& beams) {
  const std::size_t count = sweep.ranges.size();
  const bool backwards = sweep.angle_increment < 0.0;
  const double last = static_cast<double>(count - 1);
  beams.angle_increment = std::abs(sweep.angle_increment);
  beams.angle_min = sweep.X_OL.theta + sweep.angle_min + (backwards ? last * sweep.angle_increment : 0.0);
  beams.closed = (last + 1.5) * beams.angle_increment >= kTurn;
  beams.sensor = sweep.X_OL.position();
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
