#include "components/local_planner/hrvo/hrvo.hpp"

#include <algorithm>
#include <cmath>

#include "components/local_planner/hrvo/best_velocity.hpp"
#include "components/local_planner/hrvo/cones.hpp"
#include "components/local_planner/hrvo/neighbours.hpp"

namespace bw::hrvo {
namespace {

Vector2 velocity_towards(const Vector2& goal, const PlanningProblem& problem, double time_step) {
  const Vector2 way = goal - problem.pose.position();
  const double distance = way.norm();
  if (distance == 0.0) return {0.0, 0.0};
  double speed = std::min(problem.limits.v_max, distance / time_step);
  if (problem.goal_is_final) speed = std::min(speed, std::sqrt(2.0 * problem.limits.acc_max * distance));
  return (speed / distance) * way;
}

}  // namespace

Advice advise(const PlanningProblem& problem, const Vector2& goal, const HrvoOptions& options,
              const std::optional<Vector2>& last) {
  Advice advice;
  advice.preferred = velocity_towards(goal, problem, options.time_step);
  const RobotMotion robot{problem.pose.position(), problem.twist.v * direction(problem.pose.theta),
                          advice.preferred, problem.pose.theta};
  for (const Neighbour& neighbour : neighbours(problem, goal, options))
    advice.cones.push_back(cone_of(neighbour, robot, options));
  std::optional<Favour> favour;
  if (last) favour = {*last, options.hysteresis};
  const BestVelocity best = best_velocity(advice.cones, advice.preferred, problem.limits.v_max, favour);
  advice.velocity = best.velocity;
  advice.free = best.free;
  return advice;
}

}  // namespace bw::hrvo
