#include "components/explore/wavefront.hpp"

#include <cmath>
#include <cstddef>
#include <functional>
#include <queue>
#include <utility>

#include "components/model/distance_transform.hpp"

namespace bw::explore {
namespace {

bool is_open_between(const OccupancyGrid& map, const Vector2& a, const Vector2& b) {
  constexpr ObstacleRule kOccupied{};
  const int parts = static_cast<int>(std::ceil((b - a).norm() / (0.5 * map.resolution)));
  for (int k = 0; k < parts; ++k) {
    const Vector2 p = a + (b - a) * (static_cast<double>(k) / parts);
    const int column = map.column_of(p.x());
    const int row = map.row_of(p.y());
    if (map.contains(column, row) && kOccupied.blocks(map.at(column, row))) return false;
  }
  return true;
}

}  // namespace

std::vector<bool> cells_for_disc(const OccupancyGrid& map, double radius, const ObstacleRule& rule) {
  const double clearance = radius + 0.5 * map.resolution;  // between centres
  const std::vector<float> distance = distance_field(map, rule);
  std::vector<bool> fits(map.cells.size(), false);
  for (std::size_t i = 0; i < fits.size(); ++i) {
    const std::int8_t value = map.cells[i];
    fits[i] = value >= 0 && !rule.blocks(value) && static_cast<double>(distance[i]) >= clearance;
  }
  return fits;
}

std::vector<Cell> cells_beside(const OccupancyGrid& map, const std::vector<bool>& passable,
                               const Vector2& position, double reach) {
  const Cell at{map.column_of(position.x()), map.row_of(position.y())};
  if (map.contains(at.column, at.row) && passable[map.index(at.column, at.row)]) return {at};
  const int cells = static_cast<int>(std::ceil(reach / map.resolution));
  std::vector<Cell> found;
  for (int row = std::max(0, at.row - cells); row <= std::min(map.height - 1, at.row + cells); ++row)
    for (int column = std::max(0, at.column - cells); column <= std::min(map.width - 1, at.column + cells);
         ++column) {
      const Vector2 centre = map.center(column, row);
      if (!passable[map.index(column, row)] || (centre - position).norm() > reach) continue;
      if (is_open_between(map, position, centre)) found.push_back({column, row});
    }
  return found;
}

std::vector<double> wavefront(const OccupancyGrid& map, const std::vector<bool>& passable,
                              const std::vector<Cell>& starts) {
  std::vector<double> length(map.cells.size(), kUnreached);
  using Open = std::pair<double, std::size_t>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  for (const Cell start : starts) {
    length[map.index(start.column, start.row)] = 0.0;
    open.emplace(0.0, map.index(start.column, start.row));
  }
  const auto width = static_cast<std::size_t>(map.width);
  while (!open.empty()) {
    const auto [so_far, at] = open.top();
    open.pop();
    if (so_far > length[at]) continue;
    const Cell cell{static_cast<int>(at % width), static_cast<int>(at / width)};
    for_neighbours(map, cell, [&](Cell next) {
      const std::size_t i = map.index(next.column, next.row);
      if (!passable[i]) return;
      const bool is_diagonal = next.column != cell.column && next.row != cell.row;
      const double through = so_far + (is_diagonal ? std::sqrt(2.0) : 1.0) * map.resolution;
      if (through >= length[i]) return;
      length[i] = through;
      open.emplace(through, i);
    });
  }
  return length;
}

}  // namespace bw::explore
