// Which positions lie on or near the walls of a map.
#pragma once

#include "components/model/occupancy_grid.hpp"

namespace bw::people {

/// Whether the cell of `p_M`, in the map's frame, is at most `tolerance` [m] from an occupied one, from centre to centre.
/// Outside of the map nothing is known, so nothing is wall. A grid whose sizes disagree is no map.
bool is_near_wall(const OccupancyGrid& map, const Vector2& p_M, double tolerance);

}  // namespace bw::people
