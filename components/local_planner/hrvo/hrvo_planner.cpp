#include "components/local_planner/hrvo/hrvo_planner.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <utility>

#include "components/local_planner/carrot.hpp"
#include "components/local_planner/hrvo/hrvo.hpp"
#include "components/local_planner/planner_registry.hpp"
#include "components/local_planner/velocity_tracking.hpp"

namespace bw::hrvo {
namespace {

constexpr std::array kMarginShares{1.0, 0.5, 0.25};
constexpr double kMarginWorth = 0.7;  // share of v_max that keeping the whole margin may cost

// In a narrow place less margin beats turning back.
Advice best_advice(const PlanningProblem& problem, const Vector2& aim, HrvoOptions options,
                   const std::optional<Vector2>& last) {
  const double margin = options.margin;
  Advice best;
  double smallest_cost = std::numeric_limits<double>::infinity();
  for (const double share : kMarginShares) {
    options.margin = share * margin;
    Advice advice = advise(problem, aim, options, last);
    const double cost =
        (advice.velocity - advice.preferred).norm() + kMarginWorth * (1.0 - share) * problem.limits.v_max;
    const bool better = advice.free == best.free ? cost < smallest_cost : advice.free;
    if (!std::isinf(smallest_cost) && !better) continue;
    smallest_cost = cost;
    best = std::move(advice);
  }
  return best;
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
  track_velocity(problem, driving(), advice.velocity, aim, result);
  return result;
}

BW_PLANNER(HrvoPlanner, HrvoOptions, "hrvo")

}  // namespace bw::hrvo
