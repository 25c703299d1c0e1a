// What every local planner does around its own idea: turn on the spot at the goal, trust a motion only if the
// footprint stays clear, get out of somebody's way, stop.
#pragma once

#include <string>

#include "components/model/planning.hpp"
#include "runtime/parameters/field.hpp"

namespace bw {

struct DrivingOptions {
  double xy_goal_tolerance = 0.1;
  double yaw_goal_tolerance = 0.1;
  double feasibility_check_time = 3.0;
  double feasibility_margin = 0.0;
  double evasion_horizon = 2.0;
  double evasion_gap = 0.2;

  template <class Visitor>
  void fields(Visitor& v) {
    v("xy_goal_tolerance", xy_goal_tolerance,
      {.unit = "m",
       .min = 0.005,
       .max = 5,
       .doc = "from here the robot only turns to the goal heading and stops"});
    v("yaw_goal_tolerance", yaw_goal_tolerance,
      {.unit = "rad", .min = 0.005, .max = 3.15, .doc = "heading error at which it has arrived"});
    v("feasibility_check_time", feasibility_check_time,
      {.unit = "s",
       .min = 0,
       .max = 20,
       .doc = "how far ahead the footprint must be free before the robot moves"});
    v("feasibility_margin", feasibility_margin,
      {.unit = "m", .min = 0, .max = 5, .doc = "gap that this check asks for"});
    v("evasion_horizon", evasion_horizon,
      {.unit = "s", .min = 0, .max = 10, .doc = "simulated time of an evasive move; 0: only stop"});
    v("evasion_gap", evasion_gap,
      {.unit = "m", .min = 0, .max = 5, .doc = "gap beyond which evasive moves count as equally safe"});
  }
};

/// Within xy_goal_tolerance of the final goal, or, if it `had_arrived`, still within twice that.
bool has_arrived(const PlanningProblem& problem, const DrivingOptions& options, bool had_arrived);

/// Turns to the heading of the goal without leaving the place; then stands.
PlanningResult arrive(const PlanningProblem& problem, const DrivingOptions& options);

/// True when the footprint keeps feasibility_margin for the first feasibility_check_time of the motion.
bool is_free(const std::vector<TrajectoryPoint>& trajectory, const PlanningProblem& problem,
             const DrivingOptions& options);

/// A result whose command is a stop within stop_deceleration.
PlanningResult stopped(const PlanningProblem& problem, PlanningStatus status, std::string reason);

/// For a planner that found nothing free: the best evasive move (status ok, reason "evading"), or a stop
/// (status infeasible) when standing is safe or nothing is better. Candidates and figures of `result` stay.
void evade(const PlanningProblem& problem, const DrivingOptions& options, PlanningResult& result);

}  // namespace bw
