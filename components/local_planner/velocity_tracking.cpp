#include "components/local_planner/velocity_tracking.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "components/local_planner/command_limits.hpp"
#include "components/model/differential_drive.hpp"

namespace bw {
namespace {

constexpr double kStep = 0.1;  // [s] of the prediction
constexpr std::array kSpeedShares{1.0, 0.75, 0.5, 0.25, 0.0};

std::string label_of(double share) {
  return std::to_string(static_cast<int>(std::lround(100.0 * share))) + " % speed";
}

// Rotates so fast that half of alpha_max ends the rotation at the velocity's direction.
Twist2 towards(const Vector2& velocity, double heading, const PlanningProblem& problem) {
  const double error = wrap_angle(std::atan2(velocity.y(), velocity.x()) - heading);
  const double rate =
      std::min({problem.limits.omega_max, std::sqrt(problem.limits.alpha_max * std::abs(error)),
                std::abs(error) / problem.control_period});
  return {velocity.norm() * std::max(0.0, std::cos(error)), std::copysign(rate, error)};
}

// Follows `share` of the velocity's speed for `duration`, then stops; not longer than `longest` [s]. Point 1
// holds the command.
std::vector<TrajectoryPoint> followed(const Vector2& velocity, double share, double duration, double longest,
                                      const PlanningProblem& problem) {
  std::vector<TrajectoryPoint> trajectory{{0.0, problem.pose, problem.twist}};
  double step = problem.command_lead;
  do {
    const TrajectoryPoint& last = trajectory.back();
    Twist2 twist = stop_twist(last.twist, problem.limits, step);
    if (last.time < duration) {
      Twist2 wanted = towards(velocity, last.pose.theta, problem);
      wanted.v *= share;
      twist = reachable_twist(wanted, last.twist, problem.limits, step);
    }
    trajectory.push_back({last.time + step, advance_exact(last.pose, twist, step), twist});
    step = kStep;
  } while (trajectory.back().time < duration ||
           (trajectory.back().time < longest && trajectory.back().twist != Twist2{}));
  return trajectory;
}

}  // namespace

Vector2 velocity_towards(const Vector2& goal, const PlanningProblem& problem, double time_step) {
  const Vector2 to_goal = goal - problem.pose.position();
  const double distance = to_goal.norm();
  if (distance == 0.0) return {0.0, 0.0};
  double speed = std::min(problem.limits.v_max, distance / time_step);
  if (problem.goal_is_final) speed = std::min(speed, std::sqrt(2.0 * problem.limits.acc_max * distance));
  return (speed / distance) * to_goal;
}

void track_velocity(const PlanningProblem& problem, const DrivingOptions& driving, const Vector2& velocity,
                    const Vector2& aim, PlanningResult& result) {
  if (velocity.norm() < kNoDirection) {
    evade(problem, driving, result);
    return;
  }
  const double horizon = driving.feasibility_check_time;
  const double distance = (aim - problem.pose.position()).norm();
  const double duration = std::min(horizon, distance / velocity.norm());
  for (const double share : kSpeedShares) {
    std::vector<TrajectoryPoint> trajectory = followed(velocity, share, duration, horizon, problem);
    const bool free = is_free(trajectory, problem, driving);
    result.candidates.push_back({label_of(share), 1.0 - share, free, trajectory});
    if (!free) continue;
    result.status = PlanningStatus::ok;
    result.command = trajectory[1].twist;
    result.trajectory = std::move(trajectory);
    return;
  }
  evade(problem, driving, result);
}

}  // namespace bw
