#include "components/local_planner/teb/band_optimizer.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include <ceres/ceres.h>

#include "components/local_planner/teb/band_problem.hpp"

namespace bw::teb {
namespace {

constexpr double kFirstRadiusScale = 1e5;  // trust radius = this / max diag(J'J)
constexpr double kLargestCarriedRadius = 1e3;

// Adapts evaluate_segment to the free variables: the start keeps only its dt, the goal none.
class SegmentFunction final : public ceres::CostFunction {
 public:
  SegmentFunction(const BandProblem& problem, std::size_t k) : problem_(problem), k_(k) {
    rows_ = k == 0 ? kSegmentResiduals : kSegmentResiduals - 2;
    if (k + 1 == problem.segments() && !problem.scene.goal_at_rest && k != 0) rows_ = 5;
    set_num_residuals(static_cast<int>(rows_));
    for (std::size_t pose = k; pose <= k + 2 && pose + 1 < problem.band.size(); ++pose) {
      mutable_parameter_block_sizes()->push_back(pose == 0 ? 1 : 4);
    }
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const std::size_t blocks = parameter_block_sizes().size();
    SegmentStates states = problem_.segment(k_, problem_.band.poses.data());
    BandPose start = problem_.band.poses.front();
    if (k_ == 0) {
      start.dt = parameters[0][0];
      states.a = &start.x;
    } else {
      states.a = parameters[0];
    }
    if (blocks > 1) states.b = parameters[1];
    if (blocks > 2) states.c = parameters[2];

    double r[kSegmentResiduals];
    double J[kSegmentResiduals * kSegmentColumns];
    if (!evaluate_segment(problem_.segment_model, states, r, jacobians == nullptr ? nullptr : J))
      return false;
    std::copy_n(r, rows_, residuals);
    if (jacobians == nullptr) return true;
    for (std::size_t block = 0; block < blocks; ++block) {
      if (jacobians[block] == nullptr) continue;
      const auto size = static_cast<std::size_t>(parameter_block_sizes()[block]);
      const double* first = J + 4 * block + (size == 1 ? 3 : 0);
      for (std::size_t row = 0; row < rows_; ++row) {
        std::copy_n(first + row * kSegmentColumns, size, jacobians[block] + row * size);
      }
    }
    return true;
  }

 private:
  const BandProblem& problem_;
  std::size_t k_;
  std::size_t rows_;
};

// The clearance terms of pose k (one block), or of segment k (the blocks of those of its ends that are free).
class ClearanceFunction final : public ceres::CostFunction {
 public:
  ClearanceFunction(const BandProblem& problem, std::size_t k, bool along_segment)
      : problem_(problem), k_(k), along_segment_(along_segment) {
    set_num_residuals(static_cast<int>(terms().size()));
    if (k > 0) mutable_parameter_block_sizes()->push_back(4);
    if (along_segment && k + 2 < problem.band.size()) mutable_parameter_block_sizes()->push_back(4);
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const std::vector<BandPose>& poses = problem_.band.poses;
    std::size_t block = 0;
    const double* p = k_ > 0 ? parameters[block++] : &poses[k_].x;
    const double* q = block < parameter_block_sizes().size() ? parameters[block] : &poses[k_ + 1].x;
    const std::vector<ClearanceTerm>& list = terms();
    for (std::size_t i = 0; i < list.size(); ++i) {
      const double s = list[i].fraction;
      const Vector2 point((1.0 - s) * p[0] + s * q[0], (1.0 - s) * p[1] + s * q[1]);
      Vector2 gradient;
      residuals[i] = evaluate_clearance(problem_.clearance_model, list[i], point,
                                        jacobians == nullptr ? nullptr : &gradient);
      if (jacobians == nullptr) continue;
      std::size_t column_block = 0;
      const auto write = [&](double share) {
        double* J = jacobians[column_block++];
        if (J == nullptr) return;
        J += 4 * i;
        J[0] = share * gradient.x();
        J[1] = share * gradient.y();
        J[2] = 0.0;
        J[3] = 0.0;
      };
      if (k_ > 0) write(1.0 - s);
      if (column_block < parameter_block_sizes().size()) write(s);
    }
    return true;
  }

 private:
  const std::vector<ClearanceTerm>& terms() const {
    return along_segment_ ? problem_.terms[k_].along_segment : problem_.terms[k_].at_pose;
  }

  const BandProblem& problem_;
  std::size_t k_;
  bool along_segment_;
};

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
