// When no band is safe: short moves that the robot can really make, simulated among the moving obstacles; the
// best one that stays clear. Shared by every local planner.
#pragma once

#include <vector>

#include "components/model/planning.hpp"

namespace bw {

struct EvasiveMove {
  double gap = 0.0;  ///< smallest gap [m] over the horizon
  std::vector<TrajectoryPoint> trajectory;
};

/// Accelerates to each of a grid of (v, omega) targets within the limits (stop_deceleration for slowing down)
/// and holds it for `horizon` [s]; the move with the largest gap, gaps beyond `enough` [m] counting as equal
/// and then the one that ends nearest to `goal`. The first command is that of `period` [s] in the trajectory.
EvasiveMove best_evasive_move(const PlanningProblem& problem, const Vector2& goal, double horizon,
                              double period, double enough);

}  // namespace bw
