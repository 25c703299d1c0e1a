#include "components/local_planner/teb/band_candidate.hpp"

#include <algorithm>

#include "components/local_planner/teb/band_trajectory.hpp"

namespace bw::teb {
namespace {

PlanningProblem movers_of(const PlanningProblem& problem) {
  PlanningProblem alone;
  alone.pose = problem.pose;
  alone.footprint = problem.footprint;
  alone.movers = problem.movers;
  return alone;
}

}  // namespace

void check(BandCandidate& candidate, const PlanningProblem& problem, const DrivingOptions& driving) {
  candidate.trajectory = to_trajectory(candidate.band, problem.twist, problem.goal_is_final);
  candidate.safety = safety_of(candidate.trajectory, problem, driving);
  if (problem.movers.empty()) return;
  // Who comes does not wait: of movers the base has to keep clear within its limits.
  const double looked_at = std::min(candidate.band.duration(), driving.feasibility_check_time);
  const Safety driven = safety_of(as_driven(candidate.band, problem, looked_at, candidate.evasive),
                                  movers_of(problem), driving);
  candidate.safety = {candidate.safety.free && driven.free,
                      std::min(candidate.safety.comfort, driven.comfort)};
}

void improve(BandCandidate& candidate, const PlanningProblem& problem, const ObstacleField& field,
             const BandOptions& options, const DrivingOptions& driving, const Effort& effort) {
  candidate.report = optimize(candidate.band, {problem.limits, problem.twist, problem.goal_is_final, &field},
                              options, effort);
  if (!candidate.report.usable) return;
  candidate.cost = candidate.report.cost;
  check(candidate, problem, driving);
}

}  // namespace bw::teb
