#include "components/people/detector/static_map.hpp"

#include <algorithm>
#include <cmath>

#include "components/model/obstacle_rule.hpp"

namespace bw::people {

bool is_near_wall(const OccupancyGrid& map, const Vector2& p_M, double tolerance) {
  const bool sound =
      map.width > 0 && map.height > 0 && map.resolution > 0.0 && map.origin.allFinite() &&
      map.cells.size() == static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height);
  const Vector2 cell = ((p_M - map.origin) / map.resolution).array().floor();
  if (!sound || !((cell.array() >= 0.0).all() && cell.x() < map.width && cell.y() < map.height)) return false;
  const auto column = static_cast<int>(cell.x());
  const auto row = static_cast<int>(cell.y());
  const auto reach = static_cast<int>(tolerance / map.resolution) + 1;
  const auto is_within = [&](int columns, int rows) {
    const double distance = std::sqrt(static_cast<double>(columns * columns + rows * rows)) * map.resolution;
    return static_cast<float>(distance) <= tolerance;
  };
  for (int j = std::max(0, row - reach); j <= std::min(map.height - 1, row + reach); ++j)
    for (int i = std::max(0, column - reach); i <= std::min(map.width - 1, column + reach); ++i)
      if (ObstacleRule{}.blocks(map.at(i, j)) && is_within(i - column, j - row)) return true;
  return false;
}

}  // namespace bw::people
