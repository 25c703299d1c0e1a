#include "components/local_planner/hrvo/hrvo_planner.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "components/local_planner/command_limits.hpp"
#include "components/local_planner/dwa/carrot.hpp"
#include "components/local_planner/hrvo/hrvo.hpp"
#include "components/local_planner/problem_check.hpp"
#include "components/model/differential_drive.hpp"

namespace bw::hrvo {
namespace {

constexpr double kNoDirection = 0.02;  // [m/s] below which a velocity has none: stand (spec 5.3)
constexpr std::array kSpeedShares{1.0, 0.75, 0.5, 0.25, 0.0};

// Turns so fast that half of alpha_max ends the turn at the velocity's direction.
Twist2 towards(const Vector2& velocity, const PlanningProblem& problem) {
  const double speed = velocity.norm();
  if (speed < kNoDirection) return {};
  const double error = wrap_angle(std::atan2(velocity.y(), velocity.x()) - problem.pose.theta);
  const double rate =
      std::min({problem.limits.omega_max, std::sqrt(problem.limits.alpha_max * std::abs(error)),
                std::abs(error) / problem.command_lead});
  return {speed * std::max(0.0, std::cos(error)), std::copysign(rate, error)};
}

// One control period of `command`, then a stop.
std::vector<TrajectoryPoint> stopping_after(const Twist2& command, const PlanningProblem& problem) {
  constexpr double kStep = 0.1;  // [s]
  std::vector<TrajectoryPoint> trajectory{{0.0, problem.pose, problem.twist}};
  Twist2 twist = command;
  double step = problem.control_period;
  while (true) {
    const TrajectoryPoint& last = trajectory.back();
    trajectory.push_back({last.time + step, advance_exact(last.pose, twist, step), twist});
    if (twist == Twist2{}) return trajectory;
    step = kStep;
    twist = stop_twist(twist, problem.limits, step);
  }
}

}  // namespace

PlanningResult HrvoPlanner::plan(const PlanningProblem& problem) {
  if (std::string fault = fault_of(problem); !fault.empty()) {
    reset();
    return stopped(problem, PlanningStatus::bad_input, std::move(fault));
  }
  if (problem.plan.empty()) {
    reset();
    return stopped(problem, PlanningStatus::no_plan, "the plan is empty");
  }
  arrived_ = has_arrived(problem, driving_, arrived_);
  if (arrived_) return arrive(problem, driving_);

  // The point aimed at is no goal to brake for unless it is the last one.
  const double braking = problem.limits.v_max * problem.limits.v_max / (2.0 * problem.limits.acc_max);
  const Vector2 aim =
      dwa::carrot(problem.plan, problem.pose.position(), std::max(options_.lookahead, braking));
  const Advice advice = advise(problem, aim, options_);
  const Twist2 wanted = towards(advice.velocity, problem);

  PlanningResult result;
  result.iterations = 1;
  result.velocity_cones = advice.cones;
  result.velocity_wanted = advice.velocity;
  for (const double share : kSpeedShares) {
    const Twist2 command = reachable_twist({share * wanted.v, wanted.omega}, problem.twist, problem.limits,
                                           problem.command_lead);
    std::vector<TrajectoryPoint> trajectory = stopping_after(command, problem);
    const bool free = is_free(trajectory, problem, driving_);
    result.candidates.push_back({"speed", 1.0 - share, free, trajectory});
    if (!free) continue;
    result.status = PlanningStatus::ok;
    result.command = command;
    result.trajectory = std::move(trajectory);
    return result;
  }
  evade(problem, driving_, result);
  return result;
}

}  // namespace bw::hrvo
