// Random floors for planners: rooms with doors, and clutter; and start-goal pairs far apart.
#pragma once

#include <algorithm>
#include <cmath>

#include "components/global_planner/search_grid.hpp"
#include "components/mapping/rasterize.hpp"
#include "components/model/occupancy_grid.hpp"
#include "components/model/random.hpp"

namespace bw::test {

/// A square of `side` cells of 0.05 m, walled in, parted by walls every 5 m or so with doors of 1 to 2 m, and
/// one piece of clutter (a box of 0.1 to 0.6 m) for every 5 m^2.
inline OccupancyGrid random_floor(Random& random, int side) {
  OccupancyGrid grid{.resolution = 0.05, .origin = {-3.0, 7.0}, .width = side, .height = side};
  grid.cells.assign(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), OccupancyGrid::kFree);
  const double metres = side * grid.resolution;
  // (along, across) to a point: walls of both directions are drawn by the same code.
  const auto wall = [&](bool vertical, double across, double from, double to) {
    const Vector2 a = vertical ? Vector2{across, from} : Vector2{from, across};
    const Vector2 b = vertical ? Vector2{across, to} : Vector2{to, across};
    draw_segment(grid, {grid.origin + a, grid.origin + b});
  };
  for (const bool vertical : {false, true}) {
    wall(vertical, 0.02, 0.0, metres);
    wall(vertical, metres - 0.02, 0.0, metres);
    double across = random.uniform(3.0, 6.0);
    while (across < metres - 2.0) {
      double from = 0.0;
      while (from < metres) {
        const double to = from + random.uniform(1.0, 8.0);
        wall(vertical, across, from, std::min(to, metres));
        from = to + random.uniform(1.0, 2.0);
      }
      across += random.uniform(3.0, 7.0);
    }
  }
  const int clutter = static_cast<int>(metres * metres / 5.0);
  for (int i = 0; i < clutter; ++i) {
    const Vector2 corner = grid.origin + Vector2{random.uniform(0.0, metres), random.uniform(0.0, metres)};
    draw_box(grid, corner, corner + Vector2{random.uniform(0.1, 0.6), random.uniform(0.1, 0.6)});
  }
  return grid;
}

struct Trip {
  Pose2 start;
  Pose2 goal;
};

/// Free and joined, more than half a side apart. The grid must have such a pair.
inline Trip random_trip(Random& random, const SearchGrid& grid, const OccupancyGrid& map) {
  const auto cell = [&] {
    return std::pair{1 + static_cast<int>(random.uniform(0, map.width)),
                     1 + static_cast<int>(random.uniform(0, map.height))};
  };
  for (;;) {
    const auto [x0, y0] = cell();
    const auto [x1, y1] = cell();
    if (!grid.free(x0, y0) || !grid.free(x1, y1) || grid.component(x0, y0) != grid.component(x1, y1))
      continue;
    if (std::hypot(x1 - x0, y1 - y0) <= map.width / 2.0) continue;
    if (grid.narrow(x0, y0) != nullptr || grid.narrow(x1, y1) != nullptr) continue;
    const Vector2 a = grid.center(x0, y0);
    const Vector2 b = grid.center(x1, y1);
    return {{a.x(), a.y(), 0.0}, {b.x(), b.y(), 1.0}};
  }
}

}  // namespace bw::test
