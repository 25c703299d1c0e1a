#include "components/local_planner/driving.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "components/local_planner/command_limits.hpp"
#include "components/local_planner/evasion.hpp"
#include "components/local_planner/footprint_check.hpp"

namespace bw {
namespace {

constexpr double kCheckStep = 0.05;     // [m] between footprint tests
constexpr double kEnoughGap = 0.3;      // [m] beyond which evasive moves count as equally safe
constexpr double kWorthEvading = 0.03;  // [m] of comfort for which a free motion is left
constexpr double kLeaveGoalFactor =
    2.0;  // of the arrival tolerance: pushed out so far, the robot drives again

}  // namespace

GoalTolerance arrival_tolerance(const PlanningProblem& problem, const DrivingOptions& options) {
  const GoalTolerance& reached = problem.goal_tolerance;
  GoalTolerance own = inside(reached);
  if (options.xy_goal_tolerance > 0.0 && options.xy_goal_tolerance <= reached.xy)
    own.xy = options.xy_goal_tolerance;
  if (options.yaw_goal_tolerance > 0.0 && options.yaw_goal_tolerance <= reached.yaw)
    own.yaw = options.yaw_goal_tolerance;
  return own;
}

bool has_arrived(const PlanningProblem& problem, const DrivingOptions& options, bool had_arrived) {
  const double tolerance = arrival_tolerance(problem, options).xy * (had_arrived ? kLeaveGoalFactor : 1.0);
  return problem.goal_is_final &&
         (problem.plan.back().position() - problem.pose.position()).norm() <= tolerance;
}

PlanningResult arrive(const PlanningProblem& problem, const DrivingOptions& options) {
  const double error = wrap_angle(problem.plan.back().theta - problem.pose.theta);
  Twist2 wanted;
  if (std::abs(error) > arrival_tolerance(problem, options).yaw) {
    // Turn rate from which half of alpha_max still stops at the heading.
    const double rate = std::sqrt(2.0 * 0.5 * problem.limits.alpha_max * std::abs(error));
    wanted.omega = std::copysign(std::min(rate, problem.limits.omega_max), error);
  }
  PlanningResult result;
  result.status = PlanningStatus::ok;
  result.command = reachable_twist(wanted, problem.twist, problem.limits, problem.command_lead);
  result.trajectory = {{0.0, problem.pose, problem.twist}};
  return result;
}

Safety safety_of(const std::vector<TrajectoryPoint>& trajectory, const PlanningProblem& problem,
                 const DrivingOptions& options) {
  const MotionGap met =
      gap_along(trajectory, options.feasibility_check_time, kCheckStep, options.feasibility_margin, problem);
  return {std::isinf(met.contact_time), std::min(met.mover_gap, options.mover_margin)};
}

PlanningResult stopped(const PlanningProblem& problem, PlanningStatus status, std::string reason) {
  PlanningResult result;
  result.status = status;
  result.reason = std::move(reason);
  result.command = stop_twist(problem.twist, problem.limits, problem.command_lead);
  result.brakes_hard = true;
  return result;
}

bool evade(const PlanningProblem& problem, const DrivingOptions& options, const Safety& safety,
           PlanningResult& result) {
  if (safety.free && safety.comfort >= options.mover_margin) return false;
  const auto stop = [&] {
    result.status = PlanningStatus::infeasible;
    result.reason = "no motion is free and no evasive move is";
    result.command = stop_twist(problem.twist, problem.limits, problem.command_lead);
    result.brakes_hard = true;
  };
  if (options.evasion_horizon <= 0.0) {
    if (!safety.free) stop();
    return !safety.free;
  }
  EvasiveMove move = best_evasive_move(
      problem, problem.plan.back().position(),
      {options.evasion_horizon, problem.command_lead, options.feasibility_margin, kEnoughGap});
  if (safety.free && std::min(move.mover_gap, options.mover_margin) < safety.comfort + kWorthEvading)
    return false;
  stop();
  if (!safety.free && move.trajectory[1].twist == result.command) return true;
  result.status = PlanningStatus::ok;
  result.reason = "evading";
  result.command =
      evasive_twist(move.trajectory[1].twist, problem.twist, problem.limits, problem.command_lead);
  result.trajectory = std::move(move.trajectory);
  return true;
}

}  // namespace bw
