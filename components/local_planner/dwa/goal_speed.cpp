#include "components/local_planner/dwa/goal_speed.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bw::dwa {

double speed_towards_end(const PlanningProblem& problem, bool on_one_arc, double late) {
  if (!problem.goal_is_final) return problem.limits.v_max;
  const Vector2 to_goal = problem.plan.back().position() - problem.pose.position();
  const double lost = problem.limits.acc_max * late;  // [m/s]
  const double braking = std::sqrt(lost * lost + 2.0 * problem.limits.acc_max * to_goal.norm()) - lost;
  if (!on_one_arc) return braking;
  const double error = wrap_angle(std::atan2(to_goal.y(), to_goal.x()) - problem.pose.theta);
  const double sine = std::abs(error) < std::numbers::pi / 2.0 ? std::abs(std::sin(error)) : 1.0;
  const double on_the_arc = problem.limits.omega_max * to_goal.norm() / (2.0 * std::max(sine, 1e-9));
  return std::min(braking, on_the_arc);
}

}  // namespace bw::dwa
