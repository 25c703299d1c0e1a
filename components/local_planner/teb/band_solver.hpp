// The solvers of a band's least-squares problem: Ceres, and Levenberg's method on the band of blocks, by
// hand. Both see the same costs and normal equations, damp every variable alike, and end at the same minimum.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "components/local_planner/teb/band_evaluation.hpp"

namespace bw::teb {

struct SolveLimits {
  int max_iterations = 0;
  double function_tolerance = 0.0;  ///< relative gain of an iteration below which the solve ends
  double rival = std::numeric_limits<double>::infinity();  ///< cost that another band has already
  int overtime = 0;  ///< most iterations more, as long as the cost still falls fast

  /// Whether a band of this cost stays above its rival even if each of the iterations left gains as much as
  /// the last of these did. Gains mostly fall, so that little is lost with a band that is given up then.
  bool is_lost(double cost, double gain, int iterations) const {
    return iterations >= kFewest && cost - gain * std::max(0, max_iterations - iterations) > rival;
  }
  static constexpr int kFewest = 3;  ///< iterations before that is asked: the first gains say little
};

/// How the cost of one solve falls, and whether it goes on.
class SolveProgress {
 public:
  SolveProgress(const SolveLimits& limits, double cost) : limits_(limits), costs_{cost} {}

  /// After an iteration that led to this cost, or whose step was rejected (a gain of at most 0): whether it
  /// was the last.
  bool ends(double cost, double gain);

 private:
  SolveLimits limits_;
  std::vector<double> costs_;  ///< before the first iteration, and after each
};

struct SolveReport {
  bool usable = false;  ///< false: failed at the start, and the band is as it was
  int iterations = 0;   ///< steps tried, those rejected among them
  bool converged = false;
};

/// Minimises over the free variables of the band that the evaluation was made for, and leaves it there with
/// the damping of the last step. `evaluation` and `equations`: working space, and what they have to say at
/// the band as it is.
SolveReport solve_with_ceres(Band& band, BandEvaluation& evaluation, NormalEquations& equations,
                             const SolveLimits& limits);
SolveReport solve_banded(Band& band, BandEvaluation& evaluation, NormalEquations& equations,
                         const SolveLimits& limits);

}  // namespace bw::teb
