// May a motion go on? It may not when it brings about a contact that standing still would not.
#pragma once

#include <vector>

#include "components/model/planning.hpp"

namespace bw {

/// Whether the footprint comes nearer than `margin` [m] to something on `motion`, within its time, and
/// earlier or deeper than on `stop`: what is too near already blocks only motions towards it, and who walks
/// against a robot that stands blocks none that leads away.
/// Both trajectories begin at the present pose and should last equally long.
bool brings_contact(const std::vector<TrajectoryPoint>& motion, const std::vector<TrajectoryPoint>& stop,
                    double margin, const PlanningProblem& problem);

}  // namespace bw
