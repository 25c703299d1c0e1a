// A second solver of the band's least-squares problem, by hand: Levenberg's method on the block-banded normal
// equations. The oracle of the Ceres one (same residuals, same minimum), and the time to compare it with. Not
// used to drive.
#pragma once

#include "components/local_planner/teb/band_problem.hpp"

namespace bw::teb {

struct BandedReport {
  double cost = 0.0;  ///< sum of squared residuals at the end
  int iterations = 0;
  bool converged = false;
};

/// Minimises over the free variables of the band that `problem` refers to, which is left at the minimum. Ends
/// when an accepted step gains less than `function_tolerance` of the cost. The damping starts at the one the
/// Ceres solver starts with.
BandedReport solve_banded(Band& band, const BandProblem& problem, int max_iterations,
                          double function_tolerance);

/// optimize() with this solver: the same resampling, association, weights and iteration counts.
BandReport optimize_banded(Band& band, const BandScene& scene, const BandOptions& options);

}  // namespace bw::teb
