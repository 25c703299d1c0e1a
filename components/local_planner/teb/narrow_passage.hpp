// What a band asks for where there is no room for what it wants.
#pragma once

#include <vector>

#include "components/local_planner/teb/band.hpp"
#include "components/local_planner/teb/clearance_cost.hpp"

namespace bw::teb {

/// Between two static obstacles at either side of the robot's heading that leave it less than
/// min_obstacle_dist each, half of what they leave is asked for, from where they come into reach. The wanted
/// gap would not be had there, and as every pose inside or before it would cost, bands would keep their poses
/// out: the robot slows down in front of the passage and never enters. `terms`: those of pose `from` or of
/// the path to `to`. Where they leave less than `least` [m], or another obstacle stands between them, nothing
/// changes: that is no passage.
void allow_narrow_passages(std::vector<ClearanceTerm>& terms, const Footprint& footprint,
                           const BandPose& from, const BandPose& to, double min_obstacle_dist, double least);

}  // namespace bw::teb
