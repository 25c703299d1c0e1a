// What there is to be explored in a building, and how much of it a map knows. Frame: the building's.
#pragma once

#include <vector>

#include "components/explore/wavefront.hpp"
#include "components/lab/bench/buildings/building.hpp"
#include "components/model/occupancy_grid.hpp"

namespace bw {

/// The true map, and the free cells on which a robot can stand, connected with where it starts.
struct Explorable {
  OccupancyGrid truth;
  explore::Cell start;
  std::vector<bool> cells;  ///< row-major, as `truth`
};

/// Of a disc of `radius` [m] that starts at the first place of the route. Throws std::runtime_error where it does not
/// fit there.
Explorable explorable(const buildings::Building& building, double radius, double resolution);

/// Share of these cells at whose centres `map` is known to be free.
double coverage(const Explorable& place, const OccupancyGrid& map);

/// Length [m] of a tour of somebody who knows the building: always by the shortest path towards the nearest cell that
/// was not seen, until it is; all around to `range` [m]. It ends when 99.5 % were seen.
double greedy_tour(const Explorable& place, double range);

}  // namespace bw
