#include "components/global_planner/narrow_cell.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace bw {

double clearance_of(const Vector2& point, const std::vector<Capsule>& obstacles) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Capsule& obstacle : obstacles)
    nearest = std::min(nearest, distance_to(point, obstacle).distance);
  return nearest;
}

NarrowCell best_position(const Vector2& center, double edge, const std::vector<Capsule>& near) {
  NarrowCell best{.position = center, .clearance = clearance_of(center, near)};
  // Steps that halve, from a quarter of the cell on: nine positions, then eight around the best of them each
  // time.
  for (double step = edge / 4.0; step > edge / 100.0; step /= 2.0) {
    // Twice, for the best position of a ridge may lie two steps away.
    for (int round = 0; round < 2; ++round) {
      const Vector2 from = best.position;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const Vector2 position = from + step * Vector2(dx, dy);
          if ((position - center).cwiseAbs().maxCoeff() > edge / 2.0) continue;
          const double clearance = clearance_of(position, near);
          if (clearance <= best.clearance) continue;
          best.position = position;
          best.clearance = clearance;
        }
      }
    }
  }
  return best;
}

std::uint64_t free_headings(const Footprint& footprint, const Vector2& position,
                            const std::vector<Capsule>& near) {
  // A rotation by one heading moves no part of the footprint by more than this.
  const double sweep = footprint.radius * kHeadingStep;
  std::uint64_t free = kAllHeadings;
  for (const Capsule& obstacle : near) {
    if (free == 0) break;
    if (distance_to(position, obstacle).distance >= footprint.radius) continue;
    for (int i = 0; i < kHeadings;) {
      if ((free >> i & 1u) == 0) {
        ++i;
        continue;
      }
      const Pose2 pose{position.x(), position.y(), i * kHeadingStep};
      const double gap = gap_to(footprint, pose, obstacle, footprint.radius);
      const int alike = std::min(kHeadings - i, 1 + static_cast<int>(std::abs(gap) / sweep));
      if (gap < 0.0) {
        const std::uint64_t block = alike == kHeadings ? kAllHeadings : (std::uint64_t{1} << alike) - 1;
        free &= ~(block << i);
      }
      i += alike;
    }
  }
  return free;
}

std::uint64_t headings_along(double direction) {
  constexpr int kSide = kHeadings / 16;
  const int middle = static_cast<int>(std::lround(direction / kHeadingStep));
  constexpr std::uint64_t kAbout = (std::uint64_t{1} << (2 * kSide + 1)) - 1;
  const std::uint64_t ahead = std::rotl(kAbout, (middle - kSide) % kHeadings);
  return ahead | std::rotl(ahead, kHeadings / 2);
}

}  // namespace bw
