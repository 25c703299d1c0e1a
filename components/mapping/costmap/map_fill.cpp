#include "components/mapping/costmap/map_fill.hpp"

namespace bw::costmap {

void fill_unknown(OccupancyGrid& local, const OccupancyGrid& map, const Pose2& X_MO,
                  const ObstacleRule& rule) {
  const Vector2 across = direction(X_MO.theta) * local.resolution;
  for (int row = 0; row < local.height; ++row) {
    const Vector2 start = X_MO * local.center(0, row);
    for (int column = 0; column < local.width; ++column) {
      std::int8_t& value = local.cells[local.index(column, row)];
      if (value >= 0) continue;
      const Vector2 p = (start + column * across - map.origin) / map.resolution;
      if (!(p.x() >= 0.0 && p.y() >= 0.0 && p.x() < map.width && p.y() < map.height)) continue;
      const std::int8_t known = map.at(static_cast<int>(p.x()), static_cast<int>(p.y()));
      if (known >= 0) value = rule.blocks(known) ? OccupancyGrid::kOccupied : OccupancyGrid::kFree;
    }
  }
}

}  // namespace bw::costmap
