// Gaps between the beams of a laser, of which nobody thinks as unexplored ground.
#pragma once

#include "components/model/occupancy_grid.hpp"

namespace bw::explore {

/// The map with unknown cells free where they are a gap of at most `width` [m] between two free cells of their row or
/// column: far from a laser free ground is known as a comb of beams. What is narrower than a robot hides no place for it.
OccupancyGrid without_beam_gaps(const OccupancyGrid& map, double width);

}  // namespace bw::explore
