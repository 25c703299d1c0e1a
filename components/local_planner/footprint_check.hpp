// Gap between the footprint and what is around it, along motions and at the time the robot is there. Shared
// by every local planner. Of movers the confirmed alone: of a possible person there are the obstacles
// (theory.md 7.10).
#pragma once

#include "components/model/planning.hpp"

namespace bw {

/// Smallest gap [m] between the footprint at `pose` and static obstacles; negative on contact, infinite
/// without any.
double gap_to_statics(const Pose2& pose, const Footprint& footprint, const StaticObstacles& statics);

/// The same to the movers as well, where they are `time` seconds from now.
double gap_at(const Pose2& pose, double time, const Footprint& footprint, const StaticObstacles& statics,
              const std::vector<Mover>& movers);

/// What a motion meets. Gaps from 1 m on are as good as infinite.
struct MotionGap {
  double gap = 0.0;           ///< smallest gap [m]
  double mover_gap = 0.0;     ///< smallest gap to a mover [m]
  double contact_time = 0.0;  ///< when the gap first falls below the asked one [s]; infinite if it never does
};

/// The gap over the first `horizon` seconds of a trajectory, tested at least every `step` [m] of travel or
/// 0.1 s.
MotionGap gap_along(const std::vector<TrajectoryPoint>& trajectory, double horizon, double step,
                    double asked_gap, const PlanningProblem& problem);

}  // namespace bw
