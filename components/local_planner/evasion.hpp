// When no band is safe: short moves that the robot can really make, simulated among the moving obstacles; the
// best one that stays clear. Shared by every local planner.
#pragma once

#include <vector>

#include "components/model/planning.hpp"

namespace bw {

struct EvasiveMove {
  double gap = 0.0;           ///< smallest gap [m] over the horizon
  double contact_time = 0.0;  ///< [s]; infinite when the move stays clear
  std::vector<TrajectoryPoint> trajectory;
};

struct EvasionOptions {
  double horizon = 2.0;     ///< simulated time [s]
  double period = 0.1;      ///< of control [s]: the step of the simulation, so that point 1 holds the command
  double asked_gap = 0.0;   ///< below it the move counts as contact [m]
  double enough_gap = 0.2;  ///< gaps beyond it count as equal [m]
};

/// A stop that keeps enough_gap is taken at once. Else a grid of arcs, each reached within the limits
/// (stop_deceleration for slowing down) and then held, and turns that end in a straight drive. Of the moves
/// that stay clear: the largest gap, then the one that ends nearest to `goal`. If none does: the latest
/// contact, provided that it is later than a stop's and leaves time to stop; else the stop.
EvasiveMove best_evasive_move(const PlanningProblem& problem, const Vector2& goal,
                              const EvasionOptions& options);

}  // namespace bw
