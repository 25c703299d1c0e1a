#include "components/local_planner/teb/band_candidate.hpp"

#include <algorithm>

#include "components/local_planner/teb/band_trajectory.hpp"

namespace bw::teb {
void check(BandCandidate& candidate, const PlanningProblem& problem, const DrivingOptions& driving) {
  candidate.trajectory = to_trajectory(candidate.band, problem.twist, problem.goal_is_final);
  candidate.safety = safety_of(candidate.trajectory, problem, driving);
}

void improve(BandCandidate& candidate, const PlanningProblem& problem, const ObstacleField& field,
             const BandOptions& options, const DrivingOptions& driving, int max_iterations) {
  candidate.report = optimize(candidate.band, {problem.limits, problem.twist, problem.goal_is_final, &field},
                              options, max_iterations);
  if (!candidate.report.usable) return;
  candidate.cost = candidate.report.cost;
  check(candidate, problem, driving);
}

int improve_all(std::vector<BandCandidate>& candidates, const PlanningProblem& problem,
                const ObstacleField& field, const BandOptions& options, const DrivingOptions& driving,
                int max_iterations) {
  if (candidates.empty()) return 0;
  const int share = std::max(1, max_iterations / static_cast<int>(candidates.size()));
  const auto body = [&](std::size_t i) {
    const int left = std::max(0, max_iterations - static_cast<int>(i) * share);
    improve(candidates[i], problem, field, options, driving, std::min(share, left));
  };
  if (problem.parallel_for) {
    problem.parallel_for(candidates.size(), body);
  } else {
    for (std::size_t i = 0; i < candidates.size(); ++i) body(i);
  }
  int spent = 0;
  for (const BandCandidate& candidate : candidates) spent += candidate.report.iterations;
  return spent;
}

}  // namespace bw::teb
