// Shortest ways of a disc over the cells of a map: a wavefront over 8 neighbours (Dijkstra 1959).
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "components/model/obstacle_rule.hpp"
#include "components/model/occupancy_grid.hpp"

namespace bw::explore {

struct Cell {
  int column = 0;
  int row = 0;
};

inline constexpr double kUnreached = std::numeric_limits<double>::infinity();

/// Calls each(cell) with the neighbours of a cell, up to 8.
template <class Each>
void for_neighbours(const OccupancyGrid& map, Cell at, Each each) {
  for (int row = std::max(0, at.row - 1); row <= std::min(map.height - 1, at.row + 1); ++row)
    for (int column = std::max(0, at.column - 1); column <= std::min(map.width - 1, at.column + 1); ++column)
      if (row != at.row || column != at.column) each(Cell{column, row});
}

/// Known free cells on whose centre a disc of `radius` [m] touches nothing that `rule` blocks. Row-major, as `map`.
std::vector<bool> cells_for_disc(const OccupancyGrid& map, double radius, const ObstacleRule& rule);

/// The `passable` cell whose centre is nearest to a position, at most `reach` [m] away.
std::optional<Cell> nearest_cell(const OccupancyGrid& map, const std::vector<bool>& passable,
                                 const Vector2& position, double reach);

/// Length [m] of the shortest way from `start` to each cell over `passable` ones, diagonal steps included; kUnreached
/// where there is none.
std::vector<double> wavefront(const OccupancyGrid& map, const std::vector<bool>& passable, Cell start);

}  // namespace bw::explore
