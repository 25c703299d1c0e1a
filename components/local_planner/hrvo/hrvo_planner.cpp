#include "components/local_planner/hrvo/hrvo_planner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "components/local_planner/carrot.hpp"
#include "components/local_planner/command_limits.hpp"
#include "components/local_planner/hrvo/hrvo.hpp"
#include "components/local_planner/planner_factory.hpp"
#include "components/local_planner/planner_registry.hpp"
#include "components/model/differential_drive.hpp"

namespace bw::hrvo {
namespace {

constexpr double kStep = 0.1;  // [s] of the prediction
constexpr std::array kMarginShares{1.0, 0.5, 0.25};
constexpr std::array kSpeedShares{1.0, 0.75, 0.5, 0.25, 0.0};

// In a narrow place less margin beats turning back.
Advice best_advice(const PlanningProblem& problem, const Vector2& aim, HrvoOptions options,
                   const std::optional<Vector2>& last) {
  const double margin = options.margin;
  Advice best;
  double smallest_cost = std::numeric_limits<double>::infinity();
  for (const double share : kMarginShares) {
    options.margin = share * margin;
    Advice advice = advise(problem, aim, options, last);
    const double cost = (advice.velocity - advice.preferred).norm() +
                        options.margin_worth * (1.0 - share) * problem.limits.v_max;
    const bool better = advice.free == best.free ? cost < smallest_cost : advice.free;
    if (!std::isinf(smallest_cost) && !better) continue;
    smallest_cost = cost;
    best = std::move(advice);
  }
  return best;
}

std::string label_of(double share) {
  return std::to_string(static_cast<int>(std::lround(100.0 * share))) + " % speed";
}

// Turns so fast that half of alpha_max ends the turn at the velocity's direction.
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

PlanningResult HrvoPlanner::drive(const PlanningProblem& problem) {
  // The point aimed at is no goal to brake for unless it is the last one.
  const double braking = problem.limits.v_max * problem.limits.v_max / (2.0 * problem.limits.acc_max);
  const Vector2 aim = carrot(problem.plan, problem.pose.position(), std::max(options_.lookahead, braking));
  const Advice advice = best_advice(problem, aim, options_, last_);
  last_ = advice.velocity;
  PlanningResult result;
  result.iterations = 1;
  result.velocity_cones = advice.cones;
  result.velocity_wanted = advice.velocity;
  if (advice.velocity.norm() < kNoDirection) {
    evade(problem, driving(), result);
    return result;
  }
  const double horizon = driving().feasibility_check_time;
  const double way = (aim - problem.pose.position()).norm();
  const double duration = std::min(horizon, way / advice.velocity.norm());
  for (const double share : kSpeedShares) {
    std::vector<TrajectoryPoint> trajectory = followed(advice.velocity, share, duration, horizon, problem);
    const bool free = is_free(trajectory, problem, driving());
    result.candidates.push_back({label_of(share), 1.0 - share, free, trajectory});
    if (!free) continue;
    result.status = PlanningStatus::ok;
    result.command = trajectory[1].twist;
    result.trajectory = std::move(trajectory);
    return result;
  }
  evade(problem, driving(), result);
  return result;
}

namespace {

const bool kHrvo = register_planner(
    "hrvo", [](const LocalPlannerOptions& o) { return std::make_unique<HrvoPlanner>(o.hrvo, o.driving); });

}  // namespace
}  // namespace bw::hrvo
