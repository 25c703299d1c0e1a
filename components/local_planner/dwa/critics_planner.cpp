#include "components/local_planner/dwa/critics_planner.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "components/local_planner/carrot.hpp"
#include "components/local_planner/dwa/goal_speed.hpp"
#include "components/local_planner/dwa/led_plan.hpp"
#include "components/local_planner/dwa/passing_cost.hpp"
#include "components/local_planner/dwa/sample_label.hpp"
#include "components/local_planner/dwa/stopping_motion.hpp"
#include "components/local_planner/dwa/velocity_window.hpp"

namespace bw::dwa {
namespace {

// One more control period, then braking on the same curve.
bool can_brake(const RollOut& out, const PlanningProblem& problem) {
  if (!out.meets) return true;
  const Limits& limits = problem.limits;
  const double v = std::abs(out.twist.v);
  if (v > 0.0) return v * problem.control_period + v * v / (2.0 * limits.acc_max) <= out.travel;
  const double omega = std::abs(out.twist.omega);
  return omega * problem.control_period + omega * omega / (2.0 * limits.alpha_max) <= out.rotation;
}

}  // namespace

void CriticsPlanner::remember(const CheckedPlanner& earlier) {
  const auto* same = dynamic_cast<const CriticsPlanner*>(&earlier);
  if (same == nullptr) return;
  rotate_to_plan_ = same->rotate_to_plan_;
  recovery_ = same->recovery_;
}

void CriticsPlanner::forget() {
  rotate_to_plan_.forget();
  recovery_.forget();
}

std::optional<HrvoGuide> CriticsPlanner::guide_of(const PlanningProblem& problem) const {
  if (!edwa_ || !somebody_within(problem, edwa_->mover_horizon)) return std::nullopt;
  const Vector2 aim = carrot(problem.plan, problem.pose.position(), options_.carrot_distance);
  return HrvoGuide(problem, hrvo::advise(problem, aim, hrvo_), *edwa_);
}

PlanningResult CriticsPlanner::drive(const PlanningProblem& problem) {
  const CriticOptions& critics = options_.critics;
  const Course course = course_of(led_plan(problem, critics.kMargin), problem);
  const std::optional<HrvoGuide> guide = guide_of(problem);
  RollOuts roll_outs(problem, {.horizon = critics.sim_time,
                               .distance = course.line.length() - course.along,
                               .margin = critics.kMargin,
                               .reach = std::max(kInflationRadius, critics.kMargin),
                               .predict_movers = options_.predict_movers});
  const std::optional<double> rotation =
      guide && guide->has_direction() ? std::nullopt : rotate_to_plan_.angle(problem, course, critics);
  const PlanningProblem walkers = walkers_alone(problem);
  PlanningResult result;
  result.iterations = 1;
  choose(judged(problem, walkers, course, roll_outs, guide, rotation), roll_outs, walkers, result);
  Safety safety;
  if (!result.trajectory.empty()) {
    safety = {true, safety_of(result.trajectory, problem, driving()).comfort};
    if (guide)
      safety.comfort = std::min(safety.comfort, comfort_among_walkers(walkers, roll_outs, result.command));
  }
  evade(problem, driving(), safety, result);
  recovery_.apply(problem, result);
  if (guide) {
    result.velocity_cones = guide->advice().cones;
    result.velocity_wanted = guide->advice().velocity;
  }
  return result;
}

std::vector<CriticsPlanner::Judged> CriticsPlanner::judged(const PlanningProblem& problem,
                                                           const PlanningProblem& walkers,
                                                           const Course& course, RollOuts& roll_outs,
                                                           const std::optional<HrvoGuide>& guide,
                                                           std::optional<double> rotation) const {
  const CriticOptions& critics = options_.critics;
  const VelocityWindow window = velocity_window(
      problem.twist, problem.limits, speed_towards_end(problem, options_.arc_to_goal, problem.command_lead),
      problem.command_lead);
  std::optional<PassingCost> passing;
  if (guide && edwa_->passing_scale > 0.0) passing.emplace(walkers, *edwa_);
  std::vector<Judged> all;
  for (const Twist2& twist : velocity_samples(window, problem.twist, static_cast<int>(critics.vx_samples),
                                              static_cast<int>(critics.vtheta_samples))) {
    const RollOut out = roll_outs.along(twist);
    if (!can_brake(out, problem)) continue;
    const Critique c = critique(out, course, problem);
    double costs = cost(c, critics);
    if (rotation) {
      // Slower first, then the rotation; what else they cost tells equals apart.
      costs =
          1e3 * (twist.v - window.v.low) + 1e2 * rotation_left_over(twist, *rotation, problem) + 1e-3 * costs;
    } else if (guide && guide->has_direction()) {
      costs = cost_without_align(c, critics) + guide->cost(out);
    }
    if (passing) costs += passing->of(twist);
    all.push_back({out, costs});
  }
  std::sort(all.begin(), all.end(), [](const Judged& a, const Judged& b) {
    if (a.cost != b.cost) return a.cost < b.cost;
    // Of equals the straightest, so that a mirrored scene is driven mirrored.
    return std::abs(a.roll_out.twist.omega) < std::abs(b.roll_out.twist.omega);
  });
  return all;
}

void CriticsPlanner::choose(const std::vector<Judged>& judged, const RollOuts& roll_outs,
                            const PlanningProblem& walkers, PlanningResult& result) const {
  for (const Judged& one : judged) {
    const Twist2& twist = one.roll_out.twist;
    const bool chosen = result.trajectory.empty() && can_stop_among(walkers, twist);
    if (result.candidates.size() < options_.shown_candidates || chosen) {
      result.candidates.push_back(
          {label_of(twist), one.cost, chosen, roll_outs.trajectory(twist, one.roll_out.time)});
    }
    if (chosen) {
      result.status = PlanningStatus::ok;
      result.command = twist;
      result.trajectory = result.candidates.back().trajectory;
    }
    if (result.candidates.size() >= options_.shown_candidates && !result.trajectory.empty()) break;
  }
}

/// When the command is held for longer than roll-outs last: people come from farther off than what stands
/// there. It makes an evasive move worth trying; a stop is for later.
double CriticsPlanner::comfort_among_walkers(const PlanningProblem& walkers, const RollOuts& roll_outs,
                                             const Twist2& held) const {
  const auto trajectory = roll_outs.trajectory(held, driving().feasibility_check_time);
  return safety_of(trajectory, walkers, driving()).comfort;
}

bool CriticsPlanner::can_stop_among(const PlanningProblem& walkers, const Twist2& twist) const {
  if (!options_.check_movers || walkers.movers.empty()) return true;
  return is_free(stopping_motion({walkers.pose, twist}, walkers.control_period, walkers.limits.acc_max),
                 walkers, driving());
}

}  // namespace bw::dwa
