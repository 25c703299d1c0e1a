#include "components/local_planner/teb/band_optimizer.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "components/local_planner/teb/band_evaluation.hpp"
#include "components/local_planner/teb/band_solver.hpp"

namespace bw::teb {
namespace {

// Trust radius of a first solve = this / max diag(J'J). Four times larger, the first steps of a straight band
// along itself go astray: 6 % (soft weights) and 14 % (defaults) more cost after 16 iterations, in the mean
// of 64 scenes.
constexpr double kFirstRadiusScale = 2.5e4;
constexpr double kLargestCarriedRadius = 1e3;

// Nothing when the band has an interval too short to divide by.
std::optional<SolveReport> solve(Band& band, BandEvaluation& evaluation, const BandOptions& options,
                                 SolveLimits limits) {
  if (!evaluation.evaluate(band.poses.data())) return std::nullopt;
  NormalEquations equations;
  const double first_radius = kFirstRadiusScale / evaluation.linearise(equations);
  band.trust_radius = band.trust_radius > 0.0
                          ? std::clamp(band.trust_radius, first_radius, kLargestCarriedRadius)
                          : first_radius;
  switch (options.solver) {
    case Solver::banded:
      return solve_banded(band, evaluation, equations, limits);
    case Solver::ceres:
      break;
  }
  return solve_with_ceres(band, evaluation, equations, limits);
}

double share_in_choice(const BandScene& scene) {
  const Uncertainty& uncertainty = scene.obstacles->uncertainty;
  return uncertainty.factor > 0.0 ? uncertainty.in_choice : 1.0;
}

// What a band saves in the time term by intervals shorter than dt_ref, which is not a way that is better.
double saved_by_cutting(const Band& band, const BandOptions& options) {
  double saved = 0.0;
  for (std::size_t i = 0; i + 1 < band.size(); ++i)
    saved += options.weights.time * band.poses[i].dt * (options.dt_ref - band.poses[i].dt);
  return saved;
}

// What the solver minimises beyond what counts in the choice: that much more may it cost than its rival.
double cost_beyond_choice(const Band& band, const BandOptions& options, BandProblem& problem,
                          BandEvaluation& evaluation) {
  const double cut = saved_by_cutting(band, options);
  const double share = share_in_choice(problem.scene);
  if (share == 1.0 || !evaluation.evaluate(band.poses.data())) return -cut;
  const double all = evaluation.cost().obstacle;
  problem.clearance_model.unsure_share = share;
  evaluation.evaluate(band.poses.data());
  problem.clearance_model.unsure_share = 1.0;
  return all - evaluation.cost().obstacle - cut;
}

// What counts in the choice.
void add_cost(const Band& band, const BandOptions& options, BandProblem& problem, BandEvaluation& evaluation,
              BandReport& report) {
  problem.clearance_model = ClearanceModel(options, problem.scene.obstacles->footprint, 1.0);
  problem.clearance_model.unsure_share = share_in_choice(problem.scene);
  evaluation.evaluate(band.poses.data());
  report.obstacle_cost = evaluation.cost().obstacle;
  report.cost = evaluation.cost().total() + saved_by_cutting(band, options);
  for (const PoseTerms& terms : problem.terms) report.left_out += terms.left_out;
}

}  // namespace

BandReport optimize(Band& band, const BandScene& scene, const BandOptions& options, const Effort& effort) {
  BandReport report;
  if (band.size() < 2 || !band.is_finite()) return report;
  const bool warm = band.trust_radius > 0.0 && effort.first_round == 0;
  const int outer = warm ? options.warm_outer_iterations : options.no_outer_iterations;
  const int inner = warm ? options.warm_inner_iterations : options.no_inner_iterations;
  // A first plan is pushed out of obstacles step by step; a kept one is out already and keeps the true
  // weights.
  const double growth_factor = warm ? 1.0 : options.weight_adapt_factor;
  const int rounds = std::min(outer, effort.last_round);
  double growth = std::pow(growth_factor, effort.first_round);
  for (int i = effort.first_round; i < rounds; ++i, growth *= growth_factor) {
    resize(band, options);
    BandProblem problem(band, scene, options, growth);
    BandEvaluation evaluation(problem);
    const int iterations = std::min(inner, effort.max_iterations - report.iterations);
    if (iterations > 0) {
      SolveLimits limits{iterations, options.function_tolerance, effort.rival};
      if (std::isfinite(limits.rival)) limits.rival += cost_beyond_choice(band, options, problem, evaluation);
      // A plan through a crowd is far from done after a first plan's iterations.
      if (!warm && i + 1 == outer)
        limits.overtime =
            std::min(kFirstPlanOvertime, effort.max_iterations - report.iterations - iterations);
      const std::optional<SolveReport> solved = solve(band, evaluation, options, limits);
      report.usable = solved && solved->usable && band.is_finite();
      if (solved) report.iterations += solved->iterations;
      if (!report.usable) return report;
    }
    if (i + 1 == rounds) {
      report.finished = rounds == outer;
      // A first plan has moved away from the obstacles that were near it before.
      if (warm || !report.finished) {
        add_cost(band, options, problem, evaluation, report);
      } else {
        BandProblem moved(band, scene, options, 1.0);
        BandEvaluation evaluation_there(moved);
        add_cost(band, options, moved, evaluation_there, report);
      }
    }
  }
  for (BandPose& pose : band.poses) pose.theta = wrap_angle(pose.theta);
  return report;
}

}  // namespace bw::teb
