// Maps to explore, cell by cell. Cells of 0.1 m; all that is not drawn is unknown.
#pragma once

#include <cmath>

#include "components/model/occupancy_grid.hpp"

namespace bw::explore::test {

inline constexpr double kEdge = 0.1;  ///< of a cell [m]

/// From (-1, -1) to (9, 5) m.
inline OccupancyGrid unknown_map() {
  OccupancyGrid map;
  map.resolution = kEdge;
  map.origin = {-1.0, -1.0};
  map.width = 100;
  map.height = 60;
  map.cells.assign(map.index(0, map.height), OccupancyGrid::kUnknown);
  return map;
}

/// Corners in tenths of a metre, so that they lie on edges of cells.
inline void fill(OccupancyGrid& map, int left, int low, int right, int high, std::int8_t value) {
  for (int row = low + 10; row < high + 10; ++row)
    for (int column = left + 10; column < right + 10; ++column) map.cells[map.index(column, row)] = value;
}

/// Walls of one cell around free ground of 4 x 3 m from (0, 0) on.
inline OccupancyGrid closed_room() {
  OccupancyGrid map = unknown_map();
  fill(map, -1, -1, 41, 31, OccupancyGrid::kOccupied);
  fill(map, 0, 0, 40, 30, OccupancyGrid::kFree);
  return map;
}

/// With a door in the wall on the right, whose cells are known to be free, and nothing behind it.
inline OccupancyGrid room_with_door(int low, int high) {
  OccupancyGrid map = closed_room();
  fill(map, 40, low, 41, high, OccupancyGrid::kFree);
  return map;
}

}  // namespace bw::explore::test
