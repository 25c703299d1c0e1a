#include "components/local_planner/teb/band_candidate.hpp"

#include "components/local_planner/teb/band_trajectory.hpp"

namespace bw::teb {
void check(BandCandidate& candidate, const PlanningProblem& problem, const DrivingOptions& driving) {
  candidate.trajectory = to_trajectory(candidate.band, problem.twist, problem.goal_is_final);
  candidate.safety = safety_of(candidate.trajectory, problem, driving);
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
