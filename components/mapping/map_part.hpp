// A part of a map, turned upright: what is left when a map is cropped before it is saved.
#pragma once

#include "components/model/occupancy_grid.hpp"
#include "runtime/base/pose2.hpp"

namespace bw {

/// A rectangle on a map: `corner` is its lower left one, with the direction of its lower side as theta.
struct MapPart {
  Pose2 corner;
  double length = 0.0;  ///< along that side [m]
  double width = 0.0;   ///< to the left of it [m]
};

/// The part as a grid of its own, in whole cells that hold all of it. The map is turned by -theta about its
/// origin (0, 0), so that the part stands upright: what was at p is at R(-theta) p, and without a turn all
/// stays where it was. Each cell takes the value of the map's cell at its centre, beyond the map unknown.
/// Without a turn cells are the map's own. Throws std::runtime_error: a number that is not finite, a side
/// that is not positive, more than `max_cells`.
OccupancyGrid part_of(const OccupancyGrid& map, const MapPart& part, double max_cells);

}  // namespace bw
