// The one interface of every local planner: a problem in, a result out. The algorithm owns no clock, thread
// or file.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "components/model/footprint.hpp"
#include "components/model/goal_tolerance.hpp"
#include "components/model/limits.hpp"
#include "components/model/obstacles.hpp"
#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw {

/// Work a planner may spend in one cycle. Iterations, not milliseconds, so that equal input gives equal
/// output.
struct Budget {
  int max_iterations = 100;  ///< solver iterations over all candidates
};

/// Runs body(0) ... body(count - 1), possibly in parallel; returns when all are done. Empty: serially.
using ParallelFor = std::function<void(std::size_t count, const std::function<void(std::size_t)>& body)>;

/// Everything a planner may look at. One frame (odom) throughout.
struct PlanningProblem {
  Time now;
  Pose2 pose;               ///< of base_link
  Twist2 twist;             ///< measured body velocity
  std::vector<Pose2> plan;  ///< path to follow from near `pose` to the local goal, which is the last element
  bool goal_is_final = true;     ///< the local goal is the end of the journey: arrive there at rest
  GoalTolerance goal_tolerance;  ///< within which whoever set the goal calls it reached
  Footprint footprint;
  Limits limits;
  double control_period = 0.1;  ///< [s] between calls
  double command_lead = 0.1;    ///< [s] after now that the command is for: latency, and what a jerk limit
                                ///< holds back
  StaticObstacles obstacles;
  std::vector<Mover> movers;
  Budget budget;
  ParallelFor parallel_for;
};

enum class PlanningStatus {
  ok,          ///< the command follows a feasible trajectory
  no_plan,     ///< the problem holds no path to follow
  bad_input,   ///< something in the problem is not finite or makes no sense; the command is a stop
  infeasible,  ///< no collision-free trajectory was found; the command is a stop within the limits
};

struct TrajectoryPoint {
  double time = 0.0;  ///< from now [s]
  Pose2 pose;
  Twist2 twist;
};

/// One trajectory that was considered.
struct Candidate {
  std::string label;  ///< topology class or sample name, for people
  double cost = 0.0;
  bool chosen = false;
  std::vector<TrajectoryPoint> trajectory;
};

/// Velocities [m/s, planning frame] that lead to a contact with one neighbour: between the legs that leave
/// `apex` in the directions `right` and `left` (unit vectors, at most pi from right to left).
struct VelocityCone {
  Vector2 apex{0.0, 0.0};
  Vector2 right{1.0, 0.0};
  Vector2 left{0.0, 1.0};
};

struct PlanningResult {
  PlanningStatus status = PlanningStatus::no_plan;
  std::string reason;  ///< one sentence when status is not ok
  Twist2 command;      ///< finite always; a stop unless status is ok
  /// The command was reckoned with stop_deceleration and without jerk limit: a stop, or out of somebody's way.
  bool brakes_hard = false;
  std::vector<TrajectoryPoint> trajectory;
  std::vector<Candidate> candidates;
  std::vector<VelocityCone> velocity_cones;  ///< those the planner looked at
  std::optional<Vector2> velocity_wanted;    ///< the best velocity outside them
  int iterations = 0;                        ///< spent of the budget
  std::size_t obstacles_left_out = 0;  ///< times that one near a pose of the plan did not count in its cost
  bool class_switched = false;         ///< drives another class than until now
};

class LocalPlanner {
 public:
  virtual ~LocalPlanner() = default;
  virtual PlanningResult plan(const PlanningProblem& problem) = 0;
  /// Forgets warm starts: the next call is a first call.
  virtual void reset() = 0;
  /// Takes over the warm starts of an earlier planner of the same kind, whose parameters were others. Of
  /// another kind there are none.
  virtual void continue_from(const LocalPlanner&) {}
};

}  // namespace bw
