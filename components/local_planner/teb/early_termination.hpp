// How much work each band of a cycle is worth: what cannot win the choice is left early, and goes on in the
// next cycle from where it is.
#pragma once

#include <vector>

#include "components/local_planner/teb/band_candidate.hpp"

namespace bw::teb {

struct EarlyTerminationOptions {
  bool terminates_losers = false;  ///< false: all work on every band, as something else than cost decides
  double cost_hysteresis = 1.0;    ///< share of its cost that the driven band counts with
};

/// Optimises and checks all candidates, each with at most the same share of the budget, by
/// problem.parallel_for when there is one. The result does not depend on the order in which that calls.
/// Returns the iterations spent.
///
/// Losers (theory.md 6.3): a kept band ends when what its iterations gain no longer leads below the cost of
/// the driven one; a new one after the first solve of its plan, when its time and what obstacles cost it
/// there leave it no chance.
/// What they are compared with is free and keeps its distance from movers, or nobody is left.
int improve_all(std::vector<BandCandidate>& candidates, const PlanningProblem& problem,
                const ObstacleField& field, const BandOptions& options, const DrivingOptions& driving,
                const EarlyTerminationOptions& termination, int max_iterations);

}  // namespace bw::teb
