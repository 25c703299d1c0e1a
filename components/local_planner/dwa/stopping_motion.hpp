// A velocity held for a while, then braked on the same curve.
#pragma once

#include <vector>

#include "components/local_planner/dwa/arc.hpp"
#include "components/model/planning.hpp"

namespace bw::dwa {

/// The arc for `hold` [s], then `deceleration` [m/s^2] on the same curve until rest. At least two points.
std::vector<TrajectoryPoint> stopping_motion(const Arc& arc, double hold, double deceleration);

}  // namespace bw::dwa
