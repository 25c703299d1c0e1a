// Hybrid reciprocal velocity obstacles (spec 5.3; Snape, van den Berg, Guy, Manocha 2011): which velocities of
// the robot's disc lead to a contact, and the best of the others.
#pragma once

#include <vector>

#include "components/local_planner/hrvo/hrvo_options.hpp"
#include "components/model/planning.hpp"

namespace bw::hrvo {

/// What the rule says at one moment. Velocities in the planning frame [m/s].
struct Advice {
  Vector2 preferred{0.0, 0.0};  ///< straight to the goal
  Vector2 velocity{0.0, 0.0};   ///< nearest to it outside all cones, at most v_max
  bool free = true;             ///< false: there is none; `velocity` is the least bad one
  std::vector<VelocityCone> cones;
};

/// For the robot of `problem` on its way straight to `goal` [m, planning frame].
Advice advise(const PlanningProblem& problem, const Vector2& goal, const HrvoOptions& options);

}  // namespace bw::hrvo
