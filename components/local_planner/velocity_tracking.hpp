// A velocity chosen for a robot that could move any way, followed by one that has to turn. Shared by the
// planners that choose velocities.
#pragma once

#include "components/local_planner/driving.hpp"
#include "components/model/planning.hpp"

namespace bw {

/// A velocity below this [m/s] has no direction: the robot is blocked (hrvo/theory.md 5.3).
inline constexpr double kNoDirection = 0.02;

/// Straight to `goal` with v_max, slower within v_max `time_step` [s] of it, and before a final goal as
/// braking asks for.
Vector2 velocity_towards(const Vector2& goal, const PlanningProblem& problem, double time_step);

/// Fills command, trajectory, candidates and status of `result`: turn towards `velocity` [m/s, planning
/// frame], slower the further it points away from the heading, never backward; not past `aim` [m]. Of several
/// speeds, down to rotating in place, the highest whose motion over feasibility_check_time is free. If none
/// is, or the velocity has no direction: an evasive move, then a stop (status infeasible).
void track_velocity(const PlanningProblem& problem, const DrivingOptions& driving, const Vector2& velocity,
                    const Vector2& aim, PlanningResult& result);

}  // namespace bw
