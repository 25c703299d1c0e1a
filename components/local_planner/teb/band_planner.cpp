#include "components/local_planner/teb/band_planner.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "components/local_planner/command_limits.hpp"
#include "components/local_planner/problem_check.hpp"
#include "components/local_planner/teb/band_topology.hpp"
#include "components/local_planner/teb/band_trajectory.hpp"

namespace bw::teb {
namespace {

constexpr double kAdvanceSlack =
    0.5;  // [s] around the expected place on the band in which the robot is searched
constexpr double kOldestBand = 1.0;   // [s] without a call after which a band says nothing about the scene
constexpr double kDetourSlack = 1.0;  // [s] that any band may take longer than the unhindered drive

constexpr double kLeastTurn = 0.8;  // [rad] from which turning on the spot is tried for a first plan

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

}  // namespace

void BandPlanner::reset() {
  bands_.clear();
  arrived_ = false;
  acceleration_ = 0.0;
}

PlanningResult BandPlanner::plan(const PlanningProblem& problem) {
  const TebOptions& teb = options_.teb;
  if (std::string fault = fault_of(problem); !fault.empty()) {
    reset();
    return stopped(problem, PlanningStatus::bad_input, std::move(fault));
  }
  if (problem.plan.empty()) {
    reset();
    return stopped(problem, PlanningStatus::no_plan, "the plan is empty");
  }
  arrived_ = has_arrived(problem, options_.driving, arrived_);
  if (arrived_) {
    bands_.clear();
    return arrive(problem, options_.driving);
  }

  const ObstacleField field =
      nearby_obstacles(problem.obstacles, problem.movers, problem.pose.position(), problem.footprint.radius,
                       static_cast<std::size_t>(teb.band.max_obstacles), options_.prediction);
  const Band along_plan = band_along(problem.plan, problem.pose, problem.limits, teb.band);
  std::vector<BandCandidate> candidates = kept_candidates(problem);
  const std::optional<BandCandidate> as_driven = driven_of(candidates);
  planned_at_ = problem.now;
  goal_ = problem.plan.back();
  const std::optional<homotopy::Exploration> explored = add_new(problem, along_plan, candidates);
  const int budget = std::max(problem.budget.max_iterations, 1);
  int iterations = improve_all(candidates, problem, field, teb.band, options_.driving, budget);
  for (BandCandidate& candidate : candidates) candidate.evasive = false;

  std::optional<hrvo::Advice> advice;
  if (options_.hrvo) advice = hrvo::advise(problem, goal_.position(), options_.hrvo->hrvo);
  const auto judge = [&](BandCandidate& candidate) {
    candidate.cost = candidate.report.cost;
    if (options_.homotopy)
      candidate.cost += (options_.homotopy->selection_obst_cost_scale - 1.0) * candidate.report.obstacle_cost;
    if (const double margin = options_.driving.mover_margin; margin > 0.0)
      candidate.cost +=
          teb.mover_margin_cost * (1.0 - std::clamp(candidate.safety.comfort / margin, 0.0, 1.0));
    if (advice) candidate.cost += hrvo_cost(*advice, candidate.trajectory, field, options_.hrvo->weight);
  };
  for (BandCandidate& candidate : candidates) judge(candidate);
  if (explored) merge_classes(candidates, *explored, *options_.homotopy);
  std::size_t chosen = select(candidates);
  const bool detour =
      candidates[chosen].band.duration() > teb.detour_factor * along_plan.duration() + kDetourSlack;
  if (candidates[chosen].kept && (!candidates[chosen].safety.free || detour) && iterations < budget) {
    // The band may be caught between obstacles that have moved on: try what a first call would do.
    BandCandidate again{.band = along_plan, .label = "plan"};
    improve(again, problem, field, teb.band, options_.driving, budget - iterations);
    iterations += again.report.iterations;
    judge(again);
    candidates.push_back(std::move(again));
    chosen = select(candidates);
  }
  const auto comfortable = [&](const BandCandidate& c) {
    return c.safety.free && c.safety.comfort >= options_.driving.mover_margin;
  };
  if (!comfortable(candidates[chosen]) && as_driven) {
    // Nothing new is: what was planned before may still be.
    BandCandidate before = *as_driven;
    check(before, problem, options_.driving);
    before.report.usable = true;
    if (comfortable(before) || (before.safety.free && !candidates[chosen].safety.free)) {
      chosen = candidates.size();
      candidates.push_back(std::move(before));
    }
  }

  PlanningResult result;
  result.iterations = iterations;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (!candidates[i].report.usable) continue;
    result.candidates.push_back(
        {candidates[i].label, candidates[i].cost, i == chosen, candidates[i].trajectory});
  }
  if (advice) {
    result.velocity_cones = advice->cones;
    result.velocity_wanted = advice->velocity;
  }
  result.trajectory = candidates[chosen].trajectory;
  if (evade(problem, options_.driving, candidates[chosen].safety, result)) {
    if (result.status == PlanningStatus::ok) {
      // The next cycle goes on from the evasive move.
      candidates[chosen].band = band_through(result.trajectory, problem, teb.band);
      candidates[chosen].evasive = true;
      candidates[chosen].report.usable = true;
    }
  } else {
    result.status = PlanningStatus::ok;
    const BandCandidate& driven = candidates[chosen];
    const Twist2 wanted = velocity_at(driven.band, problem.twist, problem.command_lead);
    const bool hurried = driven.evasive || driven.safety.comfort < options_.driving.mover_margin;
    result.command = hurried ? evasive_twist(wanted, problem.twist, problem.limits, problem.command_lead)
                             : smooth_twist(wanted, problem.twist, acceleration_, problem.limits,
                                            problem.command_lead, problem.control_period);
  }
  acceleration_ = std::clamp((result.command.v - problem.twist.v) / problem.command_lead,
                             -problem.limits.acc_max, problem.limits.acc_max);
  keep(std::move(candidates), chosen);
  return result;
}

std::vector<BandCandidate> BandPlanner::kept_candidates(const PlanningProblem& problem) {
  const TebOptions& teb = options_.teb;
  const double elapsed = (problem.now - planned_at_).to_seconds();
  const Pose2& goal = problem.plan.back();
  std::vector<BandCandidate> candidates;
  if (elapsed < 0.0 || elapsed > kOldestBand ||
      (goal.position() - goal_.position()).norm() > teb.force_reinit_new_goal_dist ||
      std::abs(wrap_angle(goal.theta - goal_.theta)) > teb.force_reinit_new_goal_angular) {
    return candidates;
  }
  for (BandCandidate& last : bands_) {
    if (advance(last.band, problem.pose, elapsed + kAdvanceSlack, teb.band) > teb.force_reinit_start_dist) {
      continue;
    }
    set_goal(last.band, goal);
    candidates.push_back({.band = std::move(last.band),
                          .label = std::move(last.label),
                          .kept = true,
                          .driven = last.driven,
                          .settled = last.settled,
                          .evasive = last.evasive,
                          .cost = last.cost});
  }
  return candidates;
}

void BandPlanner::add_other_starts(const PlanningProblem& problem,
                                   std::vector<BandCandidate>& candidates) const {
  const TebOptions& teb = options_.teb;
  if (auto band = band_turning_first(problem.plan, problem.pose, problem.limits, teb.band, kLeastTurn))
    candidates.push_back({.band = std::move(*band), .label = "turn first"});
  if (!teb.allow_init_with_backwards_motion) return;
  if (auto band = band_backward(problem.plan, problem.pose, problem.limits, teb.band))
    candidates.push_back({.band = std::move(*band), .label = "backward"});
}

std::optional<homotopy::Exploration> BandPlanner::add_new(const PlanningProblem& problem,
                                                          const Band& along_plan,
                                                          std::vector<BandCandidate>& candidates) const {
  const BandOptions& options = options_.teb.band;
  const bool first_plan = candidates.empty();
  if (first_plan) add_other_starts(problem, candidates);
  if (!options_.homotopy) {
    if (first_plan) candidates.push_back({.band = along_plan, .label = "plan"});
    return std::nullopt;
  }
  std::vector<homotopy::Route> in_use;
  if (!first_plan) {
    for (const BandCandidate& candidate : candidates) in_use.push_back(route_of(candidate.band));
  }
  homotopy::Exploration explored =
      homotopy::explore(problem, options.min_obstacle_dist, in_use, *options_.homotopy);
  for (std::size_t i = 0; i < in_use.size(); ++i) candidates[i].label = explored.in_use_labels[i];
  for (const homotopy::Path& path : explored.paths) {
    candidates.push_back({.band = path.is_plan ? along_plan
                                               : band_along(path_of(path.route, problem.plan.back()),
                                                            problem.pose, problem.limits, options),
                          .label = path.label});
  }
  return explored;
}

std::size_t BandPlanner::select(const std::vector<BandCandidate>& candidates) const {
  if (options_.homotopy &&
      (planned_at_ - switched_at_).to_seconds() < options_.homotopy->switching_blocking_period) {
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (candidates[i].driven && candidates[i].safety.free) return i;
    }
  }
  const auto rank = [&](const BandCandidate& c) {
    const double hysteresis = options_.homotopy ? options_.homotopy->selection_cost_hysteresis : 0.95;
    return std::tuple(!c.safety.free, !c.report.usable, c.driven && c.settled ? hysteresis * c.cost : c.cost);
  };
  std::size_t best = 0;
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    if (rank(candidates[i]) < rank(candidates[best])) best = i;
  }
  return best;
}

void BandPlanner::keep(std::vector<BandCandidate> candidates, std::size_t chosen) {
  if (!bands_.empty() && !candidates[chosen].driven) switched_at_ = planned_at_;
  for (std::size_t i = 0; i < candidates.size(); ++i) candidates[i].driven = i == chosen;
  candidates[chosen].settled = candidates[chosen].kept;
  std::erase_if(candidates, [](const BandCandidate& c) { return !c.report.usable; });
  if (candidates.empty()) {
    bands_.clear();
    return;
  }
  std::stable_sort(candidates.begin(), candidates.end(), [](const BandCandidate& l, const BandCandidate& r) {
    return std::tuple(!l.driven, !l.safety.free, l.cost) < std::tuple(!r.driven, !r.safety.free, r.cost);
  });
  if (options_.homotopy) {
    const double longest =
        options_.homotopy->max_ratio_detours_duration_best_duration * candidates.front().band.duration();
    std::erase_if(candidates,
                  [&](const BandCandidate& c) { return !c.driven && c.band.duration() > longest; });
  }
  // One place stays open for a topology that is new, or better by now.
  const int most = options_.homotopy ? options_.homotopy->max_number_classes - 1 : 1;
  const auto count = static_cast<std::size_t>(std::max(most, 1));
  if (candidates.size() > count) candidates.resize(count);
  bands_ = std::move(candidates);
}

}  // namespace bw::teb
