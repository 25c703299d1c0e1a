// Exact Euclidean distance to the nearest obstacle for every cell of a grid, in time linear in the cells.
#pragma once

#include <cstddef>
#include <vector>

#include "components/mapping/obstacle_rule.hpp"
#include "components/model/occupancy_grid.hpp"

namespace bw {

/// For each cell (row-major, as in `grid`): distance [m] from its centre to the nearest centre of an obstacle
/// cell; 0 in an obstacle, infinity when the grid has none. What lies outside the grid counts as free.
/// Separable lower envelope of parabolas in integers (Meijster, Roerdink and Hesselink 2000; Felzenszwalb and
/// Huttenlocher 2012), so equal to brute force.
std::vector<float> distance_field(const OccupancyGrid& grid, const ObstacleRule& rule);

}  // namespace bw
