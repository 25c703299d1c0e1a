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
constexpr double kOldestBand = 1.0;   // [s] without a call after which a band says nothing about the scene
constexpr double kDetourSlack = 1.0;  // [s] that any band may take longer than the unhindered drive
constexpr double kSwitchFactor =
    0.95;  // of the cost of the band driven: the cost at which another one replaces it
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
  const bool kept = keep_band(problem);
  planned_at_ = problem.now;
  goal_ = goal;
  const int budget = std::max(problem.budget.max_iterations, 1);
  Band fresh = band_along(problem.plan, problem.pose, problem.limits, options_.band);
  const double unhindered_time = fresh.duration();
  Attempt attempt = improve(kept ? std::move(band_) : fresh, problem, field, budget);
  int iterations = attempt.report.iterations;
  const bool detour = attempt.band.duration() > options_.detour_factor * unhindered_time + kDetourSlack;
  if (kept && (!attempt.free || detour) && iterations < budget) {
    // The kept band may be caught between obstacles that have moved on: try what a first call would do.
    Attempt again = improve(std::move(fresh), problem, field, budget - iterations);
    iterations += again.report.iterations;
    if (again.better_than(attempt)) attempt = std::move(again);
  }

  PlanningResult result;
  result.iterations = iterations;
  result.trajectory = std::move(attempt.trajectory);
  band_ = attempt.report.usable ? std::move(attempt.band) : Band{};
  if (!attempt.free) {
    evade(problem, result);
    return result;
  }
  result.status = PlanningStatus::ok;
  result.command = reachable_twist(velocity_at(band_, problem.twist, options_.control_period), problem.twist,
                                   problem.limits, options_.control_period);
  result.candidates.push_back({"band", attempt.report.cost, true, result.trajectory});
  return result;
}

bool TebPlanner::Attempt::better_than(const Attempt& other) const {
  if (free != other.free) return free;
  if (report.usable != other.report.usable) return report.usable;
  return free && report.cost < kSwitchFactor * other.report.cost;
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

TebPlanner::Attempt TebPlanner::improve(Band band, const PlanningProblem& problem, const ObstacleField& field,
                                        int budget) const {
  Attempt attempt;
  attempt.band = std::move(band);
  attempt.report = optimize(attempt.band, {problem.limits, problem.twist, problem.goal_is_final, &field},
                            options_.band, budget);
  if (!attempt.report.usable) return attempt;
  attempt.trajectory = to_trajectory(attempt.band, problem.twist, problem.goal_is_final);
  attempt.free = is_free(problem, attempt.trajectory);
  return attempt;
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
