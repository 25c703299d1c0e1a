#include "components/local_planner/hrvo/hrvo.hpp"

#include "components/local_planner/hrvo/best_velocity.hpp"
#include "components/local_planner/hrvo/cones.hpp"
#include "components/local_planner/hrvo/neighbours.hpp"

namespace bw::hrvo {
namespace {

constexpr double kHysteresis =
    0.1;  // [m/s] by which a way round must be nearer to the preferred velocity than the last one

}  // namespace

Advice advise(const PlanningProblem& problem, const Vector2& goal, const HrvoOptions& options,
              const std::optional<Vector2>& last) {
  Advice advice;
  advice.preferred = velocity_towards(goal, problem, kTimeStep);
  const RobotMotion robot{problem.pose.position(), problem.twist.v * direction(problem.pose.theta),
                          advice.preferred, problem.pose.theta};
  for (const Neighbour& neighbour : neighbours(problem, goal, options))
    advice.cones.push_back(cone_of(neighbour, robot, options));
  std::optional<PreviousVelocity> favour;
  if (last) favour = {*last, kHysteresis};
  const BestVelocity best = best_velocity(advice.cones, advice.preferred, problem.limits.v_max, favour);
  advice.velocity = best.velocity;
  advice.free = best.free;
  return advice;
}

}  // namespace bw::hrvo
