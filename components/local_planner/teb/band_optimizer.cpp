#include "components/local_planner/teb/band_optimizer.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include <ceres/ceres.h>

#include "components/local_planner/teb/band_functions.hpp"
#include "components/local_planner/teb/band_problem.hpp"

namespace bw::teb {
namespace {

constexpr double kFirstRadiusScale = 1e5;  // trust radius = this / max diag(J'J)
constexpr double kLargestCarriedRadius = 1e3;

double* block_of(Band& band, std::size_t pose) { return pose == 0 ? &band.poses[0].dt : &band.poses[pose].x; }

ceres::Solver::Options solver_options(const BandOptions& options, int iterations, double radius) {
  ceres::Solver::Options solver;
  solver.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  solver.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
  solver.num_threads = 1;
  solver.logging_type = ceres::SILENT;
  // The same damping for every variable. Damping scaled by diag(J'J) lets the directions along the band,
  // which hinge costs hardly determine, run away: the plan then never converges.
  solver.jacobi_scaling = false;
  solver.min_lm_diagonal = 1.0;
  solver.max_lm_diagonal = 1.0;
  solver.initial_trust_region_radius = radius;
  solver.max_num_iterations = iterations;
  solver.function_tolerance = options.function_tolerance;
  solver.gradient_tolerance = 1e-8;
  solver.parameter_tolerance = 0.0;  // relative to the coordinates: it would ask less far from the origin
  return solver;
}

ceres::Solver::Summary solve(Band& band, const BandProblem& problem, const ceres::Solver::Options& solver) {
  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ownership.disable_all_safety_checks = true;
  ceres::Problem least_squares(ownership);
  std::deque<SegmentFunction> segments;
  std::deque<ClearanceFunction> clearances;
  std::vector<double*> blocks;
  for (std::size_t k = 0; k < problem.segments(); ++k) {
    blocks.clear();
    for (std::size_t pose = k; pose <= k + 2 && pose + 1 < band.size(); ++pose)
      blocks.push_back(block_of(band, pose));
    least_squares.AddResidualBlock(&segments.emplace_back(problem, k), nullptr, blocks);
  }
  for (std::size_t k = 0; k < problem.segments(); ++k) {
    if (!problem.terms[k].at_pose.empty()) {
      least_squares.AddResidualBlock(&clearances.emplace_back(problem, k, false), nullptr, block_of(band, k));
    }
    if (!problem.terms[k].along_segment.empty()) {
      blocks.clear();
      if (k > 0) blocks.push_back(block_of(band, k));
      if (k + 2 < band.size()) blocks.push_back(block_of(band, k + 1));
      if (blocks.empty()) continue;
      least_squares.AddResidualBlock(&clearances.emplace_back(problem, k, true), nullptr, blocks);
    }
  }
  ceres::Solver::Summary summary;
  ceres::Solve(solver, &least_squares, &summary);
  return summary;
}

}  // namespace

BandReport optimize(Band& band, const BandScene& scene, const BandOptions& options, int max_iterations) {
  BandReport report;
  if (band.size() < 2 || !band.is_finite()) return report;
  const bool warm = band.trust_radius > 0.0;
  const int outer = warm ? options.warm_outer_iterations : options.no_outer_iterations;
  const int inner = warm ? options.warm_inner_iterations : options.no_inner_iterations;
  // A first plan is pushed out of obstacles step by step; a kept one is out already and keeps the true
  // weights.
  const double growth_factor = warm ? 1.0 : options.weight_adapt_factor;
  double growth = 1.0;
  for (int i = 0; i < outer; ++i, growth *= growth_factor) {
    resize(band, options);
    BandProblem problem(band, scene, options, growth);
    const double first_radius = kFirstRadiusScale / problem.largest_information();
    const double radius = band.trust_radius > 0.0
                              ? std::clamp(band.trust_radius, first_radius, kLargestCarriedRadius)
                              : first_radius;
    const int iterations = std::min(inner, max_iterations - report.iterations);
    if (iterations > 0) {
      const ceres::Solver::Summary summary =
          solve(band, problem, solver_options(options, iterations, radius));
      if (!summary.iterations.empty()) {
        report.iterations += static_cast<int>(summary.iterations.size()) - 1;
        band.trust_radius = summary.iterations.back().trust_region_radius;
      }
      report.usable = summary.IsSolutionUsable() && band.is_finite();
      if (!report.usable) return report;
    }
    if (i + 1 == outer) {
      problem.clearance_model = ClearanceModel(options, 1.0);
      const BandCost cost = problem.cost(band.poses.data());
      report.obstacle_cost = cost.obstacle;
      report.cost = cost.total();
    }
  }
  for (BandPose& pose : band.poses) pose.theta = wrap_angle(pose.theta);
  return report;
}

}  // namespace bw::teb
