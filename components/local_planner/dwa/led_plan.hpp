// A plan that leads through what stands there, led around it: DWB's wavefronts run around obstacles,
// distances along a plan do not.
#pragma once

#include <vector>

#include "components/model/planning.hpp"

namespace bw::dwa {

inline constexpr double kStanding = 0.15;  ///< who is slower stands [m/s]

/// The plan of `problem`, whose first stretch that the largest disc in the footprint does not fit through is
/// replaced by the shortest path around what stands there, `margin` [m] from it where possible; movers slower
/// than kStanding stand. Looks 6 m ahead and 3 m aside, in cells of 0.1 m. The plan itself where it is free,
/// or no path leads around. Nothing in it depends on the frame, and a mirrored scene gives the mirrored plan.
std::vector<Pose2> led_plan(const PlanningProblem& problem, double margin);

}  // namespace bw::dwa
