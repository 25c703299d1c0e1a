#include "components/local_planner/teb/band_planner.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "components/local_planner/command_limits.hpp"
#include "components/local_planner/teb/band_trajectory.hpp"
#include "components/local_planner/teb/early_termination.hpp"

namespace bw::teb {
namespace {

constexpr double kAdvanceSlack =
    0.5;  // [s] around the expected position on the band in which the robot is searched
constexpr double kOldestBand = 1.0;    // [s] without a call after which a band says nothing about the scene
constexpr double kDetourSlack = 1.0;   // [s] that any band may take longer than the unhindered drive
constexpr double kDetourFactor = 1.3;  // and this many times longer; else it is compared with a new one
constexpr double kNewGoalDistance = 1.0;  // [m] by which a goal that moves further starts a new band
constexpr double kNewGoalRotation = 0.8;  // [rad] by which its heading, likewise
constexpr double kLostDistance = 0.5;     // [m] from its band at which the robot starts a new one
constexpr double kLeastRotation = 0.8;    // [rad] from which rotating in place is tried for a first plan

int budget_of(const PlanningProblem& problem) { return std::max(problem.budget.max_iterations, 1); }

std::optional<BandCandidate> driven_of(const std::vector<BandCandidate>& candidates) {
  for (const BandCandidate& candidate : candidates) {
    if (candidate.driven) return candidate;
  }
  return std::nullopt;
}

// Along `motion`, then straight along the rest of the plan.
Band band_through(const std::vector<TrajectoryPoint>& motion, const PlanningProblem& problem,
                  const BandOptions& options) {
  const Band rest = band_along(problem.plan, motion.back().pose, problem.limits, options);
  Band band;
  for (std::size_t i = 0; i + 1 < motion.size(); ++i) {
    const Pose2& p = motion[i].pose;
    band.poses.push_back({p.x, p.y, p.theta, motion[i + 1].time - motion[i].time});
  }
  band.poses.insert(band.poses.end(), rest.poses.begin(), rest.poses.end());
  return band;
}

// What was considered, for people to see.
PlanningResult report(const std::vector<BandCandidate>& candidates, std::size_t chosen,
                      const ChoiceTerm& term) {
  PlanningResult result;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const BandCandidate& c = candidates[i];
    if (c.report.usable) result.candidates.push_back({c.label, c.cost, i == chosen, c.trajectory});
  }
  if (term.advice) {
    result.velocity_cones = term.advice->cones;
    result.velocity_wanted = term.advice->velocity;
  }
  result.trajectory = candidates[chosen].trajectory;
  result.obstacles_left_out = candidates[chosen].report.left_out;
  return result;
}

}  // namespace

struct BandPlanner::Cycle {
  const PlanningProblem& problem;
  BandOptions band;  ///< with what this robot keeps from movers
  ObstacleField field;
  Band along_plan;
  ChoiceTerm term;
  std::vector<BandCandidate> candidates;
  std::optional<BandCandidate> as_driven;  // the driven band of the last cycle, not optimised since
  std::function<void(std::vector<BandCandidate>&)> merge;
  std::size_t chosen = 0;
  int iterations = 0;
};

void BandPlanner::forget() {
  bands_.clear();
  acceleration_ = 0.0;
}

void BandPlanner::remember(const CheckedPlanner& earlier) {
  const auto* other = dynamic_cast<const BandPlanner*>(&earlier);
  if (other == nullptr) return;
  bands_ = other->bands_;
  planned_at_ = other->planned_at_;
  switched_at_ = other->switched_at_;
  goal_ = other->goal_;
  acceleration_ = other->acceleration_;
}

PlanningResult BandPlanner::drive(const PlanningProblem& problem) {
  BandOptions band = options_.teb.band;
  band.dynamic_obstacle_inflation_dist += pedestrian_lead(options_.field, problem.limits.v_max);
  Cycle cycle{.problem = problem,
              .band = band,
              .field = field_of(problem.obstacles, problem.movers, problem.pose.position(), problem.footprint,
                                options_.field),
              .along_plan = band_along(problem.plan, problem.pose, problem.limits, band)};
  cycle.candidates = kept_candidates(problem);
  cycle.as_driven = driven_of(cycle.candidates);
  planned_at_ = problem.now;
  goal_ = problem.plan.back();
  add_new_bands(cycle);
  improve_bands(cycle);
  choose(cycle);
  try_along_plan(cycle);
  try_as_driven(cycle);
  PlanningResult result = report(cycle.candidates, cycle.chosen, cycle.term);
  result.iterations = cycle.iterations;
  command(cycle, result);
  result.class_switched = !bands_.empty() && !cycle.candidates[cycle.chosen].driven;
  if (result.class_switched) switched_at_ = planned_at_;
  bands_ = worth_keeping(std::move(cycle.candidates), cycle.chosen, options_.selection);
  return result;
}

std::vector<BandCandidate> BandPlanner::kept_candidates(const PlanningProblem& problem) {
  const TebOptions& teb = options_.teb;
  const double elapsed = (problem.now - planned_at_).to_seconds();
  const Pose2& goal = problem.plan.back();
  std::vector<BandCandidate> candidates;
  if (elapsed < 0.0 || elapsed > kOldestBand ||
      (goal.position() - goal_.position()).norm() > kNewGoalDistance ||
      std::abs(wrap_angle(goal.theta - goal_.theta)) > kNewGoalRotation) {
    return candidates;
  }
  for (BandCandidate& last : bands_) {
    if (advance(last.band, problem.pose, elapsed + kAdvanceSlack, teb.band) > kLostDistance) {
      continue;
    }
    set_goal(last.band, goal);
    candidates.push_back({.band = std::move(last.band),
                          .label = std::move(last.label),
                          .kept = true,
                          .spare = last.spare,
                          .driven = last.driven,
                          .settled = last.settled,
                          .evasive = last.evasive,
                          .cost = last.cost});
  }
  return candidates;
}

std::vector<BandCandidate> BandPlanner::other_starts(const PlanningProblem& problem) const {
  const TebOptions& teb = options_.teb;
  std::vector<BandCandidate> starts;
  if (auto band = band_rotating_first(problem.plan, problem.pose, problem.limits, teb.band, kLeastRotation))
    starts.push_back({.band = std::move(*band), .label = "turn first"});
  if (!teb.allow_init_with_backwards_motion) return starts;
  if (auto band = band_backward(problem.plan, problem.pose, problem.limits, teb.band))
    starts.push_back({.band = std::move(*band), .label = "backward"});
  return starts;
}

void BandPlanner::add_new_bands(Cycle& cycle) const {
  std::vector<BandCandidate>& candidates = cycle.candidates;
  NewBands found = options_.source(cycle.problem, cycle.along_plan, candidates);
  if (candidates.empty()) candidates = other_starts(cycle.problem);
  std::move(found.candidates.begin(), found.candidates.end(), std::back_inserter(candidates));
  cycle.merge = std::move(found.merge);
}

void BandPlanner::improve_bands(Cycle& cycle) const {
  // One band competes with nobody; and where more than cost decides, cost does not tell who loses.
  const bool by_cost = !options_.term && options_.selection.obstacle_cost_scale == 1.0;
  const EarlyTerminationOptions termination{options_.selection.max_kept > 1 && by_cost,
                                            options_.selection.cost_hysteresis};
  cycle.iterations = improve_all(cycle.candidates, cycle.problem, cycle.field, cycle.band, options_.driving,
                                 termination, budget_of(cycle.problem));
  for (BandCandidate& candidate : cycle.candidates) candidate.evasive = false;
}

double BandPlanner::choice_cost(const BandCandidate& candidate, const Cycle& cycle) const {
  double cost =
      candidate.report.cost + (options_.selection.obstacle_cost_scale - 1.0) * candidate.report.obstacle_cost;
  if (const double margin = options_.driving.mover_margin; margin > 0.0)
    cost += kMoverMarginCost * (1.0 - std::clamp(candidate.safety.comfort / margin, 0.0, 1.0));
  if (cycle.term.cost) cost += cycle.term.cost(candidate);
  return cost;
}

void BandPlanner::choose(Cycle& cycle) const {
  if (options_.term) cycle.term = options_.term(cycle.problem, cycle.field);
  for (BandCandidate& candidate : cycle.candidates) candidate.cost = choice_cost(candidate, cycle);
  cycle.merge(cycle.candidates);
  cycle.chosen = select(cycle.candidates, options_.selection, (planned_at_ - switched_at_).to_seconds());
}

void BandPlanner::try_along_plan(Cycle& cycle) const {
  const BandCandidate& chosen = cycle.candidates[cycle.chosen];
  const int left = budget_of(cycle.problem) - cycle.iterations;
  const bool detour = chosen.band.duration() > kDetourFactor * cycle.along_plan.duration() + kDetourSlack;
  if (!chosen.kept || (chosen.safety.free && !detour) || left <= 0) return;
  BandCandidate again{.band = cycle.along_plan, .label = "plan"};
  improve(again, cycle.problem, cycle.field, cycle.band, options_.driving, {.max_iterations = left});
  cycle.iterations += again.report.iterations;
  again.cost = choice_cost(again, cycle);
  cycle.candidates.push_back(std::move(again));
  cycle.chosen = select(cycle.candidates, options_.selection, (planned_at_ - switched_at_).to_seconds());
}

void BandPlanner::try_as_driven(Cycle& cycle) const {
  const BandCandidate& chosen = cycle.candidates[cycle.chosen];
  if (is_comfortable(chosen) || !cycle.as_driven) return;
  BandCandidate before = *cycle.as_driven;
  check(before, cycle.problem, options_.driving);
  before.report.usable = true;
  if (!is_comfortable(before) && (!before.safety.free || chosen.safety.free)) return;
  cycle.chosen = cycle.candidates.size();
  cycle.candidates.push_back(std::move(before));
}

bool BandPlanner::is_comfortable(const BandCandidate& candidate) const {
  return candidate.safety.free && candidate.safety.comfort >= options_.driving.mover_margin;
}

void BandPlanner::command(Cycle& cycle, PlanningResult& result) {
  const PlanningProblem& problem = cycle.problem;
  BandCandidate& chosen = cycle.candidates[cycle.chosen];
  if (!evade(problem, options_.driving, chosen.safety, result)) {
    result.status = PlanningStatus::ok;
    const Twist2 wanted = velocity_at(chosen.band, problem.twist, problem.command_lead);
    const bool hurried = chosen.evasive || chosen.safety.comfort < options_.driving.mover_margin;
    result.command = hurried ? evasive_twist(wanted, problem.twist, problem.limits, problem.command_lead)
                             : smooth_twist(wanted, problem.twist, acceleration_, problem.limits,
                                            problem.command_lead, problem.control_period);
    result.brakes_hard = hurried;
  } else if (result.status == PlanningStatus::ok) {
    chosen.band = band_through(result.trajectory, problem, options_.teb.band);
    chosen.evasive = true;
    chosen.report.usable = true;
  }
  acceleration_ = std::clamp((result.command.v - problem.twist.v) / problem.command_lead,
                             -problem.limits.acc_max, problem.limits.acc_max);
}

}  // namespace bw::teb
