// Which way round a scene is, so that its mirror image is sampled in a mirror.
#pragma once

#include "components/model/planning.hpp"

namespace bw::mppi {

/// 1 or -1: the side of the first of these that is on one: the end of the plan, the rotation of the robot,
/// obstacles, movers and their velocities. Mirrored scenes have the other sign, equal ones wherever they lie
/// the same. 1 where nothing is on either side.
double side_of(const PlanningProblem& problem);

}  // namespace bw::mppi
