#include "components/lab/bench/buildings/known_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "components/mapping/rasterize.hpp"

namespace bw::buildings {
namespace {

/// Unknown everywhere, with two cells to spare around the walls.
OccupancyGrid empty_grid(const std::vector<Segment>& walls, double resolution) {
  Vector2 low = walls.front().a;
  Vector2 high = low;
  for (const Segment& wall : walls) {
    low = low.cwiseMin(wall.a).cwiseMin(wall.b);
    high = high.cwiseMax(wall.a).cwiseMax(wall.b);
  }
  OccupancyGrid grid;
  grid.resolution = resolution;
  grid.origin = resolution * ((low / resolution).array().floor() - 2.0).matrix();
  grid.width = grid.column_of(high.x()) + 3;
  grid.height = grid.row_of(high.y()) + 3;
  grid.cells.assign(grid.index(0, grid.height), OccupancyGrid::kUnknown);
  return grid;
}

void fill_free(OccupancyGrid& grid, const Vector2& from) {
  std::vector<std::pair<int, int>> waiting;
  const auto fill = [&](int column, int row) {
    if (!grid.contains(column, row) || grid.at(column, row) != OccupancyGrid::kUnknown) return;
    grid.cells[grid.index(column, row)] = OccupancyGrid::kFree;
    waiting.emplace_back(column, row);
  };
  fill(grid.column_of(from.x()), grid.row_of(from.y()));
  if (waiting.empty()) throw std::invalid_argument("the route starts in a wall");
  while (!waiting.empty()) {
    const auto [column, row] = waiting.back();
    waiting.pop_back();
    fill(column + 1, row);
    fill(column - 1, row);
    fill(column, row + 1);
    fill(column, row - 1);
  }
}

bool touches_free(const OccupancyGrid& grid, int column, int row) {
  for (int r = std::max(0, row - 1); r <= std::min(grid.height - 1, row + 1); ++r) {
    for (int c = std::max(0, column - 1); c <= std::min(grid.width - 1, column + 1); ++c) {
      if (grid.at(c, r) == OccupancyGrid::kFree) return true;
    }
  }
  return false;
}

}  // namespace

OccupancyGrid known_map(const Building& building, double resolution) {
  if (building.walls.empty() || building.route.empty())
    throw std::invalid_argument("a building without walls or route");
  OccupancyGrid grid = empty_grid(building.walls, resolution);
  for (const Segment& wall : building.walls) draw_segment(grid, wall);
  fill_free(grid, building.route.front());
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      std::int8_t& cell = grid.cells[grid.index(column, row)];
      if (cell == OccupancyGrid::kOccupied && !touches_free(grid, column, row))
        cell = OccupancyGrid::kUnknown;
    }
  }
  return grid;
}

}  // namespace bw::buildings
