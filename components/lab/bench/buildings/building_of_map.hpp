// The building of a map: what map_server's file shows as a place to drive in. Frame: the map's.
#pragma once

#include <string>

#include "components/lab/bench/buildings/building.hpp"
#include "components/model/occupancy_grid.hpp"

namespace bw::buildings {

/// Walls lie along the borders between cells that are free and cells that are not, unknown ones among these. The route
/// is `start` alone [m].
Building building_of_map(const std::string& name, const OccupancyGrid& map, const Vector2& start);

}  // namespace bw::buildings
