// Grids that the mapping tests share.
#pragma once

#include "components/model/occupancy_grid.hpp"
#include "components/model/random.hpp"

namespace bw::test {

inline OccupancyGrid empty_grid(int width, int height, double resolution = 0.05,
                                const Vector2& origin = {0.0, 0.0}) {
  OccupancyGrid grid{.resolution = resolution, .origin = origin, .width = width, .height = height};
  grid.cells.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), OccupancyGrid::kFree);
  return grid;
}

inline OccupancyGrid random_grid(Random& random, int width, int height, double density) {
  OccupancyGrid grid =
      empty_grid(width, height, random.uniform(0.01, 0.2), {random.normal(), random.normal()});
  for (auto& cell : grid.cells) {
    if (random.uniform() < density) cell = OccupancyGrid::kOccupied;
  }
  return grid;
}

}  // namespace bw::test
