#include "components/local_planner/dwa/passing_cost.hpp"

#include <algorithm>
#include <cmath>

#include "components/local_planner/dwa/led_plan.hpp"
#include "components/model/mover_weight.hpp"

namespace bw::dwa {
namespace {

constexpr double kDeepest = 0.3;  // [m] that somebody may be touched by and one motion be better than another
constexpr double kAnyWay = 1e3;   // [m]: it is the time that ends them

}  // namespace

PlanningProblem walkers_alone(const PlanningProblem& problem) {
  PlanningProblem walkers;
  walkers.now = problem.now;
  walkers.pose = problem.pose;
  walkers.twist = problem.twist;
  walkers.footprint = problem.footprint;
  walkers.limits = problem.limits;
  walkers.control_period = problem.control_period;
  walkers.command_lead = problem.command_lead;
  for (const Mover& mover : problem.movers)
    if (is_confirmed(mover) && mover.velocity.norm() >= kStanding) walkers.movers.push_back(mover);
  return walkers;
}

PassingCost::PassingCost(const PlanningProblem& walkers, const EdwaOptions& options)
    : options_(options),
      roll_outs_(walkers, {.horizon = options.mover_horizon,
                           .way = kAnyWay,
                           .margin = -kDeepest,
                           .reach = options.passing_gap,
                           .predict_movers = true}) {}

double PassingCost::of(const Twist2& held) {
  const RollOut out = roll_outs_.along(held);
  const double gap = out.meets ? -kDeepest : out.gap;
  const double missing = std::max(0.0, options_.passing_gap - gap) / options_.passing_gap;
  const double when = (out.meets ? out.time : out.gap_time) / options_.mover_horizon;
  const double soon = out.meets ? 1.0 - when : 0.0;
  return options_.passing_scale *
         (std::pow(missing, options_.passing_power) * (1.0 - options_.passing_fading * when) + soon);
}

}  // namespace bw::dwa
