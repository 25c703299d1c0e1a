// What the planner pays for each cell, in the numbers of Nav2's costmaps (cell_cost.hpp).
#pragma once

#include <cstdint>
#include <vector>

#include "components/global_planner/search_grid.hpp"
#include "components/model/occupancy_grid.hpp"

namespace bw {

/// Of the cells of `map`, from which `grid` was built: unknown 255 where it is an obstacle because of that,
/// an obstacle 254, 253 where the robot would touch one, and below 0 to 252 in proportion to what the cell
/// costs beyond a free one, of the most that `clearance_weight` makes of it (theory.md 7.4).
std::vector<std::uint8_t> costs_of(const SearchGrid& grid, const OccupancyGrid& map, double clearance_weight);

}  // namespace bw
