// The true map of a building.
#pragma once

#include "components/lab/bench/buildings/building.hpp"
#include "components/model/occupancy_grid.hpp"

namespace bw::buildings {

/// Occupied: cells that hold a part of a wall and touch a free one (8 neighbours). Free: what is connected
/// (4 neighbours) with the start of the route. The rest is unknown, such as the inside of walls and of
/// cupboards: no robot can see it. Throws std::invalid_argument when the route is empty or starts in a wall.
OccupancyGrid known_map(const Building& building, double resolution = 0.05);

}  // namespace bw::buildings
