// Shortest ways of a disc over the cells of a map: a wavefront over 8 neighbours (Dijkstra 1959).
#pragma once

#include <algorithm>
#include <limits>
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

/// Known free cells on whose centre a disc of `radius` [m] touches no cell that `rule` blocks. Row-major, as `map`. Cells
/// count as the global planner has them, half a cell around their middles.
std::vector<bool> cells_for_disc(const OccupancyGrid& map, double radius, const ObstacleRule& rule);

/// The `passable` cells that a robot at `position` stands on or can come onto: its own, or else all within `reach` [m] with
/// nothing occupied in between.
std::vector<Cell> cells_beside(const OccupancyGrid& map, const std::vector<bool>& passable,
                               const Vector2& position, double reach);

/// Length [m] of the shortest way from the nearest of `starts` to each cell over `passable` ones, diagonal steps included;
/// kUnreached where there is none.
std::vector<double> wavefront(const OccupancyGrid& map, const std::vector<bool>& passable,
                              const std::vector<Cell>& starts);

}  // namespace bw::explore
