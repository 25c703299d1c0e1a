#include "components/local_planner/dwa/passing_cost.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "components/local_planner/dwa/led_plan.hpp"
#include "components/model/mover_weight.hpp"

namespace bw::dwa {
namespace {

constexpr double kDeepestTouch =
    0.3;  // [m] that somebody may be touched by and one motion be better than another
constexpr double kAnyDistance = 1e3;  // [m]: it is the time that ends them

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

PassingCost::Group::Group(PlanningProblem among, const EdwaOptions& options)
    : problem(std::move(among)),
      roll_outs(problem, {.horizon = options.mover_horizon,
                          .distance = kAnyDistance,
                          .margin = -kDeepestTouch,
                          .reach = options.passing_gap,
                          .predict_movers = true}) {}

double PassingCost::Group::cost(const Twist2& held, const EdwaOptions& options, double power, double fading) {
  const RollOut out = roll_outs.along(held);
  const double gap = out.meets ? -kDeepestTouch : out.gap;
  const double missing = std::max(0.0, options.passing_gap - gap) / options.passing_gap;
  const double when = (out.meets ? out.time : out.gap_time) / options.mover_horizon;
  const double soon = out.meets ? 1.0 - when : 0.0;
  return options.passing_scale * (std::pow(missing, power) * (1.0 - fading * when) + soon);
}

PassingCost::PassingCost(const PlanningProblem& walkers, const EdwaOptions& options) : options_(options) {
  PlanningProblem fast = walkers, slow = walkers;
  const auto is_fast = [&](const Mover& mover) { return mover.velocity.norm() >= walkers.limits.v_max; };
  std::erase_if(fast.movers, [&](const Mover& mover) { return !is_fast(mover); });
  std::erase_if(slow.movers, is_fast);
  if (!fast.movers.empty()) fast_.emplace(std::move(fast), options);
  if (!slow.movers.empty()) slow_.emplace(std::move(slow), options);
}

double PassingCost::of(const Twist2& held) {
  const double fast = fast_ ? fast_->cost(held, options_, 1.0, 0.0) : 0.0;
  const double slow =
      slow_ ? slow_->cost(held, options_, options_.passing_power, options_.passing_fading) : 0.0;
  return std::max(fast, slow);
}

}  // namespace bw::dwa
