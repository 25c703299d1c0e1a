#include <algorithm>
#include <cmath>
#include <limits>

#include "components/local_planner/teb/band_solver.hpp"

namespace bw::teb {
namespace {

constexpr double kLargestDamping = 1e12;

// Moves `from` by the step; start and goal have none. Returns the gain that the equations predict.
double step_from(const std::vector<BandPose>& from, const BandVector& step, const BandVector& gradient,
                 double damping, std::vector<BandPose>& to) {
  double predicted = 0.0;
  for (std::size_t k = 0; k + 1 < from.size(); ++k) {
    const std::array<double, 4>& s = step[k];
    to[k] = {from[k].x + s[0], from[k].y + s[1], from[k].theta + s[2], from[k].dt + s[3]};
    for (std::size_t i = 0; i < 4; ++i) predicted += s[i] * (damping * s[i] - gradient[k][i]);
  }
  return predicted;
}

}  // namespace

SolveReport solve_banded(Band& band, BandEvaluation& evaluation, NormalEquations& equations,
                         const SolveLimits& limits) {
  SolveReport report{.usable = true};
  double cost = evaluation.cost().total();
  double damping = 1.0 / band.trust_radius;
  double growth = 2.0;
  BandFactor factor;
  BandVector step;
  std::vector<BandPose> trial = band.poses;
  SolveProgress progress(limits, cost);
  for (; report.iterations < limits.max_iterations + limits.overtime && damping < kLargestDamping;
       ++report.iterations) {
    double gain = -std::numeric_limits<double>::infinity();
    double predicted = 0.0;
    if (factor.factorise(equations, damping)) {
      step = equations.gradient;
      for (std::array<double, 4>& s : step) s = {-s[0], -s[1], -s[2], -s[3]};
      factor.solve_transposed(step);
      factor.solve(step);
      predicted = step_from(band.poses, step, equations.gradient, damping, trial);
      if (evaluation.evaluate(trial.data())) gain = cost - evaluation.cost().total();
    }
    report.converged = std::abs(gain) <= limits.function_tolerance * cost;
    if (gain > 0.0) {
      band.poses.swap(trial);
      const double agreement = 2.0 * gain / predicted - 1.0;
      damping *= std::max(1.0 / 3.0, 1.0 - agreement * agreement * agreement);
      growth = 2.0;
      cost -= gain;
    } else {
      damping *= growth;
      growth *= 2.0;
    }
    if (progress.ends(cost, gain) || report.converged) {
      ++report.iterations;
      break;
    }
    if (gain > 0.0) evaluation.linearise(equations);
  }
  band.trust_radius = 1.0 / damping;
  return report;
}

}  // namespace bw::teb
