// Beams that ended at people say nothing of walls.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "components/model/laser_sweep.hpp"
#include "components/model/obstacles.hpp"

namespace bw::slam {

/// [m] around a track: legs swing, and tracks err
inline constexpr double kAroundPerson = 0.15;

/// The sweep's ranges, NaN where a beam ended in one of `people` (in the sweep's frame F) or within kAroundPerson of it: it
/// says neither what stands there nor what is free behind.
inline std::vector<float> without_people(const LaserSweep& sweep, std::span<const Disc> people) {
  std::vector<float> ranges(sweep.ranges.begin(), sweep.ranges.end());
  if (people.empty()) return ranges;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (kind_of(ranges[i], sweep) != BeamKind::hit) continue;
    const double range = static_cast<double>(ranges[i]);
    const Vector2 end = scanner_at(sweep, i) *
                        (range * direction(sweep.angle_min + static_cast<double>(i) * sweep.angle_increment));
    for (const Disc& person : people) {
      const double reach = person.radius + kAroundPerson;
      if ((end - person.center).squaredNorm() > reach * reach) continue;
      ranges[i] = std::numeric_limits<float>::quiet_NaN();
      break;
    }
  }
  return ranges;
}

}  // namespace bw::slam
