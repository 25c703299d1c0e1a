// A grid of cells over the plane, as nav_msgs/OccupancyGrid means it.
#pragma once

#include <cstdint>
#include <vector>

#include "runtime/base/pose2.hpp"

namespace bw {

/// Cell (column, row): column along +x, row along +y from the lower left corner `origin` [m]. Row-major.
struct OccupancyGrid {
  static constexpr std::int8_t kUnknown = -1;
  static constexpr std::int8_t kFree = 0;
  static constexpr std::int8_t kOccupied = 100;

  double resolution = 0.05;  ///< edge of a cell [m]
  Vector2 origin{0.0, 0.0};  ///< lower left corner of cell (0, 0); the grid is not rotated
  int width = 0;
  int height = 0;
  std::vector<std::int8_t> cells;  ///< width * height values: kUnknown, or 0 (free) to 100 (occupied)

  bool contains(int column, int row) const {
    return column >= 0 && row >= 0 && column < width && row < height;
  }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  }
  std::int8_t at(int column, int row) const { return cells[index(column, row)]; }
  int column_of(double x) const { return static_cast<int>(std::floor((x - origin.x()) / resolution)); }
  int row_of(double y) const { return static_cast<int>(std::floor((y - origin.y()) / resolution)); }
  Vector2 center(int column, int row) const {
    return {origin.x() + (column + 0.5) * resolution, origin.y() + (row + 0.5) * resolution};
  }
};

}  // namespace bw
