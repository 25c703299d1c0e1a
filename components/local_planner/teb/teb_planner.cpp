#include "components/local_planner/teb/teb_planner.hpp"

#include <algorithm>
#include <cmath>

#include "components/local_planner/command_limits.hpp"
#include "components/local_planner/evasion.hpp"
#include "components/local_planner/footprint_check.hpp"
#include "components/local_planner/problem_check.hpp"
#include "components/local_planner/teb/band_trajectory.hpp"

namespace bw::teb {
namespace {

constexpr double kCheckStep = 0.05;  // [m] between footprint tests
constexpr double kAdvanceSlack =
    0.5;  // [s] around the expected place on the band in which the robot is searched
constexpr double kOldestBand = 1.0;  // [s] without a call after which a band says nothing about the scene
constexpr double kLeaveGoalFactor =
    2.0;  // of xy_goal_tolerance: pushed out so far, a robot that had arrived drives again

PlanningResult stop(const PlanningProblem& problem, PlanningStatus status, std::string reason,
                    double period) {
  PlanningResult result;
  result.status = status;
  result.reason = std::move(reason);
  result.command = stop_twist(problem.twist, problem.limits, period);
  return result;
}

}  // namespace

void TebPlanner::reset() {
  band_ = {};
  arrived_ = false;
}

PlanningResult TebPlanner::plan(const PlanningProblem& problem) {
  const std::string fault = fault_of(problem);
  if (!fault.empty()) {
    reset();
    return stop(problem, PlanningStatus::bad_input, fault, options_.control_period);
  }
  if (problem.plan.empty()) {
    reset();
    return stop(problem, PlanningStatus::no_plan, "the plan is empty", options_.control_period);
  }
  const Pose2& goal = problem.plan.back();
  const double tolerance = options_.xy_goal_tolerance * (arrived_ ? kLeaveGoalFactor : 1.0);
  arrived_ = problem.goal_is_final && (goal.position() - problem.pose.position()).norm() <= tolerance;
  if (arrived_) {
    band_ = {};
    return arrive(problem);
  }

  const ObstacleField field =
      nearby_obstacles(problem.obstacles, problem.movers, problem.pose.position(), problem.footprint.radius,
                       static_cast<std::size_t>(options_.band.max_obstacles));
  PlanningResult result;
  const bool kept = keep_band(problem);
  if (!kept) band_ = band_along(problem.plan, problem.pose, problem.limits, options_.band);
  planned_at_ = problem.now;
  goal_ = goal;
  const int budget = std::max(problem.budget.max_iterations, 1);
  BandReport report = improve(band_, problem, field, budget);
  result.iterations = report.iterations;
  if (report.usable) result.trajectory = to_trajectory(band_, problem.twist, problem.goal_is_final);
  bool free = report.usable && is_free(problem, result.trajectory);

  if (!free && kept && report.iterations < budget) {
    // The kept band may be caught between obstacles that have moved on: try what a first call would do.
    Band fresh = band_along(problem.plan, problem.pose, problem.limits, options_.band);
    const BandReport again = improve(fresh, problem, field, budget - report.iterations);
    result.iterations += again.iterations;
    const std::vector<TrajectoryPoint> trajectory =
        to_trajectory(fresh, problem.twist, problem.goal_is_final);
    free = again.usable && is_free(problem, trajectory);
    if (free || !report.usable) {
      report = again;
      band_ = std::move(fresh);
      result.trajectory = trajectory;
    }
  }
  if (free) {
    result.status = PlanningStatus::ok;
    result.command = reachable_twist(velocity_at(band_, problem.twist, options_.control_period),
                                     problem.twist, problem.limits, options_.control_period);
    result.candidates.push_back({"band", report.cost, true, result.trajectory});
    return result;
  }
  if (!report.usable) band_ = {};
  evade(problem, result);
  return result;
}

bool TebPlanner::keep_band(const PlanningProblem& problem) {
  const double elapsed = (problem.now - planned_at_).to_seconds();
  if (band_.size() < 2 || elapsed < 0.0 || elapsed > kOldestBand) return false;
  const Pose2& goal = problem.plan.back();
  if ((goal.position() - goal_.position()).norm() > options_.force_reinit_new_goal_dist) return false;
  if (std::abs(wrap_angle(goal.theta - goal_.theta)) > options_.force_reinit_new_goal_angular) return false;
  if (advance(band_, problem.pose, elapsed + kAdvanceSlack, options_.band) >
      options_.force_reinit_start_dist) {
    return false;
  }
  set_goal(band_, goal);
  return true;
}

BandReport TebPlanner::improve(Band& band, const PlanningProblem& problem, const ObstacleField& field,
                               int budget) const {
  return optimize(band, {problem.limits, problem.twist, problem.goal_is_final, &field}, options_.band,
                  budget);
}

bool TebPlanner::is_free(const PlanningProblem& problem,
                         const std::vector<TrajectoryPoint>& trajectory) const {
  return std::isinf(
      gap_along(trajectory, options_.feasibility_check_time, kCheckStep, options_.feasibility_margin, problem)
          .contact_time);
}

PlanningResult TebPlanner::arrive(const PlanningProblem& problem) const {
  const double error = wrap_angle(problem.plan.back().theta - problem.pose.theta);
  Twist2 wanted;
  if (std::abs(error) > options_.yaw_goal_tolerance) {
    // Turn rate from which alpha_max still stops at the heading.
    const double rate = std::sqrt(2.0 * 0.5 * problem.limits.alpha_max * std::abs(error));
    wanted.omega = std::copysign(std::min(rate, problem.limits.omega_max), error);
  }
  PlanningResult result;
  result.status = PlanningStatus::ok;
  result.command = reachable_twist(wanted, problem.twist, problem.limits, options_.control_period);
  result.trajectory = {{0.0, problem.pose, problem.twist}};
  return result;
}

void TebPlanner::evade(const PlanningProblem& problem, PlanningResult& result) const {
  result.status = PlanningStatus::infeasible;
  result.reason = "the band is not free and no evasive move is";
  result.command = stop_twist(problem.twist, problem.limits, options_.control_period);
  if (options_.evasion_horizon <= 0.0) return;
  EvasiveMove move = best_evasive_move(problem, problem.plan.back().position(),
                                       {options_.evasion_horizon, options_.control_period,
                                        options_.feasibility_margin, options_.band.min_obstacle_dist});
  if (move.trajectory[1].twist == result.command) return;
  result.status = PlanningStatus::ok;
  result.reason = "evading";
  result.command = move.trajectory[1].twist;
  result.trajectory = std::move(move.trajectory);
}

}  // namespace bw::teb
