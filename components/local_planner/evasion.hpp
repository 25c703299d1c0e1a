// When no planned motion is safe: short moves that the robot can really make, simulated among the moving
// obstacles; the best one that stays clear. Shared by every local planner.
#pragma once

#include <vector>

#include "components/model/planning.hpp"

namespace bw {

struct EvasiveMove {
  double gap = 0.0;           ///< smallest gap [m] over the horizon; at most enough_gap
  double mover_gap = 0.0;     ///< smallest gap to a mover [m]; at most enough_gap
  double contact_time = 0.0;  ///< [s]; infinite when the move stays clear
  std::vector<TrajectoryPoint> trajectory;
};

struct EvasionOptions {
  double horizon = 3.0;  ///< simulated time [s]
  double period = 0.1;  ///< of control [s]: the step of the simulation (at least 0.05), so that point 1 holds
                        ///< the command
  double asked_gap =
      0.0;  ///< below it the move counts as contact [m]; where something is nearer already, what
            ///< comes a centimetre closer
  double enough_gap = 0.3;     ///< gaps beyond it count as equal [m]
  double error_growth = 0.15;  ///< [m/s] by which where movers will be is less sure, the later it is
};

/// A stop that keeps enough_gap is taken at once. Else moves in three phases, each towards a velocity reached
/// within the limits (stop_deceleration for slowing down) and then held. Of the moves that stay clear: the
/// largest gap, then (a centimetre of gap is worth a metre) the one that ends nearest to `goal`. If none
/// does: of the moves in which the robot runs into nobody and touches nothing that stands, the one whose gap
/// falls least below enough_gap - error_growth t, as movers will not be exactly where they are expected. If
/// there is none either: the latest contact, provided that it is later than a stop's and leaves time to stop;
/// else the stop.
/// Who is touched already is no contact: in place of the largest gap counts then how far the move, at its
/// worst moment, falls short of a gap that grows from the present one by 0.1 m a second.
/// Among very many obstacles the search ends early, always at the same move.
EvasiveMove best_evasive_move(const PlanningProblem& problem, const Vector2& goal,
                              const EvasionOptions& options);

}  // namespace bw
