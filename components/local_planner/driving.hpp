// What every local planner does around its own idea: rotate in place at the goal, trust a motion only if the
// footprint stays clear, get out of somebody's way, stop.
#pragma once

#include <string>

#include "components/model/planning.hpp"
#include "runtime/base/field.hpp"

namespace bw {

struct DrivingOptions {
  double xy_goal_tolerance = 0.0;
  double yaw_goal_tolerance = 0.0;
  double feasibility_check_time = 3.0;
  double feasibility_margin = 0.0;
  double mover_margin = 0.1;
  double evasion_horizon = 3.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("xy_goal_tolerance", xy_goal_tolerance,
      {.unit = "m",
       .min = 0,
       .max = 5,
       .doc = "from here the robot only turns to the goal heading and stops; 0, or more than the navigator's "
              "xy_tolerance: half of that"});
    v("yaw_goal_tolerance", yaw_goal_tolerance,
      {.unit = "rad",
       .min = 0,
       .max = 3.15,
       .doc = "heading error at which it has arrived; 0, or more than the navigator's yaw_tolerance: a third "
              "of that"});
    v("feasibility_check_time", feasibility_check_time,
      {.unit = "s",
       .min = 0,
       .max = 20,
       .doc = "how far ahead the footprint must be free before the robot moves; longer is safer, and "
              "stops more often in crowds"});
    v("feasibility_margin", feasibility_margin,
      {.unit = "m",
       .min = 0,
       .max = 5,
       .doc = "gap that the check of the footprint asks for; raise it where the robot drives less exactly "
              "than it plans"});
    v("mover_margin", mover_margin,
      {.unit = "m",
       .min = 0,
       .max = 5,
       .doc = "a motion that passes a mover with a smaller gap is left for an evasive move that keeps more"});
    v("evasion_horizon", evasion_horizon,
      {.unit = "s",
       .min = 0,
       .max = 10,
       .doc = "how long an evasive move is simulated ahead; 0: the robot only stops"});
  }
};

/// Where the planner ends its drive: what `options` say, or, where they say nothing or would end it outside
/// of what counts as reached, inside(problem.goal_tolerance).
GoalTolerance arrival_tolerance(const PlanningProblem& problem, const DrivingOptions& options);

/// Within arrival_tolerance of the final goal, or, if it `had_arrived`, still within twice that.
bool has_arrived(const PlanningProblem& problem, const DrivingOptions& options, bool had_arrived);

/// Turns to the heading of the goal without leaving the place; then stands.
PlanningResult arrive(const PlanningProblem& problem, const DrivingOptions& options);

/// How far a motion can be trusted over the first feasibility_check_time.
struct Safety {
  bool free = false;     ///< the footprint keeps feasibility_margin
  double comfort = 0.0;  ///< the gap to movers where it is below mover_margin, else mover_margin [m]
};
Safety safety_of(const std::vector<TrajectoryPoint>& trajectory, const PlanningProblem& problem,
                 const DrivingOptions& options);

inline bool is_free(const std::vector<TrajectoryPoint>& trajectory, const PlanningProblem& problem,
                    const DrivingOptions& options) {
  return safety_of(trajectory, problem, options).free;
}

/// A result whose command is a stop within stop_deceleration, braked hard.
PlanningResult stopped(const PlanningProblem& problem, PlanningStatus status, std::string reason);

/// For a planner whose best motion has `safety`: true, and `result` is an evasive move (status ok, reason
/// "evading"), when one keeps clearly more comfort. Without a free motion: that, or a stop (status
/// infeasible) when standing is safe or nothing is better; true always. Candidates and figures of `result`
/// stay.
bool evade(const PlanningProblem& problem, const DrivingOptions& options, const Safety& safety,
           PlanningResult& result);
inline void evade(const PlanningProblem& problem, const DrivingOptions& options, PlanningResult& result) {
  evade(problem, options, Safety{}, result);
}

}  // namespace bw
