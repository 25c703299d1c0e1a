#include "components/local_planner/mppi/side.hpp"

#include <cmath>

#include "components/model/mover_weight.hpp"

namespace bw::mppi {
namespace {

constexpr double kOnNeither = 1e-6;  // far above what rounding does to a position

}  // namespace

double side_of(const PlanningProblem& problem) {
  const Pose2 X_BO = inverse(problem.pose);
  double obstacles = 0.0, movers = 0.0, velocities = 0.0;
  for (const Vector2& p : problem.obstacles.points) obstacles += (X_BO * p).y();
  for (const Disc& d : problem.obstacles.discs) obstacles += (X_BO * d.center).y();
  for (const Segment& s : problem.obstacles.segments) obstacles += (X_BO * s.a).y() + (X_BO * s.b).y();
  for (const Mover& m : problem.movers) {
    if (!is_confirmed(m)) continue;
    movers += (X_BO * m.position).y();
    velocities += rotate(X_BO, m.velocity).y();
  }
  const double plan = (X_BO * problem.plan.back().position()).y();
  for (const double aside : {plan, problem.twist.omega, obstacles, movers, velocities}) {
    if (std::abs(aside) > kOnNeither) return aside > 0.0 ? 1.0 : -1.0;
  }
  return 1.0;
}

}  // namespace bw::mppi
