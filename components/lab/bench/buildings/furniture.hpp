// Furniture at drawn places, out of the way of the route.
#pragma once

#include "components/lab/bench/buildings/floor_plan.hpp"

namespace bw::buildings {

struct FurnitureOptions {
  int count = 0;             ///< that are tried to be placed; fewer where there is no room
  double longest = 1.6;      ///< [m]
  double deepest = 0.7;      ///< [m]
  double along_walls = 0.7;  ///< share of those that stand at a side of the area; others stand anyhow
};

/// Stands boxes into `area`, none of them on another or nearer to the plan's route, which must be there
/// already, than it allows.
void furnish(FloorPlan& plan, const Rectangle& area, const FurnitureOptions& options, Random& random);

}  // namespace bw::buildings
