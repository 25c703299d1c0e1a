#include "components/local_planner/teb/band_planner.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "components/local_planner/command_limits.hpp"
#include "components/local_planner/problem_check.hpp"
#include "components/local_planner/teb/band_class.hpp"
#include "components/local_planner/teb/band_trajectory.hpp"

namespace bw::teb {
namespace {

constexpr double kAdvanceSlack =
    0.5;  // [s] around the expected place on the band in which the robot is searched
constexpr double kOldestBand = 1.0;   // [s] without a call after which a band says nothing about the scene
constexpr double kDetourSlack = 1.0;  // [s] that any band may take longer than the unhindered drive

}  // namespace

void BandPlanner::reset() {
  bands_.clear();
  arrived_ = false;
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
  planned_at_ = problem.now;
  goal_ = problem.plan.back();
  add_new(problem, along_plan, candidates);
  const int budget = std::max(problem.budget.max_iterations, 1);
  int iterations = improve_all(candidates, problem, field, teb.band, options_.driving, budget);

  std::optional<hrvo::Advice> advice;
  if (options_.hrvo) advice = hrvo::advise(problem, goal_.position(), options_.hrvo->hrvo);
  const auto judge = [&](BandCandidate& candidate) {
    candidate.cost = candidate.report.cost;
    if (advice) candidate.cost += hrvo_cost(*advice, candidate.trajectory, field, options_.hrvo->weight);
  };
  for (BandCandidate& candidate : candidates) judge(candidate);
  std::size_t chosen = select(candidates);
  const bool detour =
      candidates[chosen].band.duration() > teb.detour_factor * along_plan.duration() + kDetourSlack;
  if (candidates[chosen].kept && (!candidates[chosen].free || detour) && iterations < budget) {
    // The band may be caught between obstacles that have moved on: try what a first call would do.
    BandCandidate again{.band = along_plan, .label = "plan"};
    improve(again, problem, field, teb.band, options_.driving, budget - iterations);
    iterations += again.report.iterations;
    judge(again);
    candidates.push_back(std::move(again));
    chosen = select(candidates);
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
  if (candidates[chosen].free) {
    result.status = PlanningStatus::ok;
    result.command =
        reachable_twist(velocity_at(candidates[chosen].band, problem.twist, problem.command_lead),
                        problem.twist, problem.limits, problem.command_lead);
  } else {
    evade(problem, options_.driving, result);
  }
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
    candidates.push_back(
        {.band = std::move(last.band), .label = std::move(last.label), .kept = true, .driven = last.driven});
  }
  return candidates;
}

void BandPlanner::add_new([[maybe_unused]] const PlanningProblem& problem, const Band& along_plan,
                          std::vector<BandCandidate>& candidates) {
  if (!options_.homotopy) {
    if (candidates.empty()) candidates.push_back({.band = along_plan, .label = "plan"});
    return;
  }
}

std::size_t BandPlanner::select(const std::vector<BandCandidate>& candidates) const {
  const auto rank = [&](const BandCandidate& c) {
    const double hysteresis = options_.homotopy ? options_.homotopy->selection_cost_hysteresis : 0.95;
    return std::tuple(!c.free, !c.report.usable, c.driven ? hysteresis * c.cost : c.cost);
  };
  std::size_t best = 0;
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    if (rank(candidates[i]) < rank(candidates[best])) best = i;
  }
  return best;
}

void BandPlanner::keep(std::vector<BandCandidate> candidates, std::size_t chosen) {
  bands_.clear();
  candidates[chosen].driven = true;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (i != chosen) candidates[i].driven = false;
    if (candidates[i].report.usable) bands_.push_back(std::move(candidates[i]));
  }
}

}  // namespace bw::teb
