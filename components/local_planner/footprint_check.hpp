// Gap between the footprint and what is around it, along motions and at the time the robot is there. Shared
// by every local planner. Of movers the confirmed alone: of a possible person there are the obstacles (book 7.10).
#pragma once

#include "components/model/planning.hpp"

namespace bw {

/// Gap [m] between the footprint at `pose` and all points within `radius` of segment a-b, which is a point
/// when a and b are equal. Negative on contact (a lower bound of the depth). Where the enclosing disc of a
/// polygon is clear, the gap of that disc.
double gap_to(const Pose2& pose, const Footprint& footprint, const Vector2& a, const Vector2& b,
              double radius);

/// The smallest of these to static obstacles; infinite without any.
double gap_to_statics(const Pose2& pose, const Footprint& footprint, const StaticObstacles& statics);

/// Smallest gap [m] between the footprint at `pose` and the obstacles `time` seconds from now; negative on
/// contact (a lower bound of the depth). Infinite without obstacles.
double gap_at(const Pose2& pose, double time, const Footprint& footprint, const StaticObstacles& statics,
              const std::vector<Mover>& movers);

/// What a motion meets.
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
