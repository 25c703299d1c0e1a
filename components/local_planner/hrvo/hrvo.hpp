// Hybrid reciprocal velocity obstacles (theory.md 5.3; Snape, van den Berg, Guy, Manocha 2011): which
// velocities of the robot's disc lead to a contact, and the best of the others.
#pragma once

#include <optional>
#include <vector>

#include "components/local_planner/hrvo/hrvo_options.hpp"
#include "components/local_planner/velocity_tracking.hpp"
#include "components/model/planning.hpp"

namespace bw::hrvo {

using bw::kNoDirection;

/// What the rule says at one moment. Velocities in the planning frame [m/s].
struct Advice {
  Vector2 preferred{0.0, 0.0};      ///< straight to the goal
  Vector2 velocity{0.0, 0.0};       ///< nearest to it outside all cones, at most v_max
  bool free = true;                 ///< false: there is none; `velocity` meets the farthest neighbour first
  std::vector<VelocityCone> cones;  ///< nearest neighbour first; a half plane has opposite legs
};

/// For the robot of `problem` on its way straight to `goal` [m, planning frame], where it comes to rest if
/// the problem's goal is final. The problem must be sound (fault_of). The robot's velocity is v dir(theta).
/// `last` is the velocity advised before: ways round that are almost as good as it do not replace it.
Advice advise(const PlanningProblem& problem, const Vector2& goal, const HrvoOptions& options,
              const std::optional<Vector2>& last = {});

}  // namespace bw::hrvo
