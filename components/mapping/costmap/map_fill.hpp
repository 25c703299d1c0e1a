// What the map knows of cells that nobody has seen yet.
#pragma once

#include "components/model/obstacle_rule.hpp"
#include "components/model/occupancy_grid.hpp"

namespace bw::costmap {

/// Each unknown cell of `local` (in odom) takes what the map says at its centre: occupied, or free. X_MO:
/// odom in map. Cells that were seen keep what was seen.
void fill_unknown(OccupancyGrid& local, const OccupancyGrid& map, const Pose2& X_MO,
                  const ObstacleRule& rule);

}  // namespace bw::costmap
