#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include <ceres/ceres.h>

#include "components/local_planner/teb/band_solver.hpp"

namespace bw::teb {
namespace {

// Variables of a parameter block: those of two poses. A row of R then ends with the next block, and half as
// many blocks are kept book of as with one for each pose; with three poses the zeros among them cost more.
constexpr std::size_t kBlock = 8;

// Ceres gets the square root of the normal equations instead of the terms they are made of: R with R'R = J'J
// and q with R'q = J'r. These are four rows a pose where the terms are a dozen and more, of the same cost,
// gradient and Gauss-Newton step; what is left of the cost is a residual that nothing changes. All is
// computed at once, before Ceres asks the cost functions for their rows.
class SquareRoot final : public ceres::EvaluationCallback {
 public:
  /// Evaluation and equations are at the band as it is: the first point that Ceres asks for.
  SquareRoot(const Band& band, BandEvaluation& evaluation, NormalEquations& equations)
      : band_(band), evaluation_(evaluation), equations_(equations) {}

  void PrepareForEvaluation(bool evaluate_jacobians, bool new_evaluation_point) override {
    const bool known = std::exchange(at_start_, false);
    if (new_evaluation_point && !known) finite_ = evaluation_.evaluate(band_.poses.data());
    if (!finite_) return;
    const double cost = evaluation_.cost().total();
    rest_ = std::sqrt(cost);
    if (!evaluate_jacobians) return;
    if (!known) evaluation_.linearise(equations_);
    // J'J is singular where penalties are flat. A damping far below the solver's makes it regular.
    double damping = kRegular * equations_.largest_information();
    while (!factor_.factorise(equations_, damping)) damping *= 100.0;
    residuals_ = equations_.gradient;
    factor_.solve_transposed(residuals_);
    double explained = 0.0;
    for (const std::array<double, 4>& q : residuals_) {
      for (const double x : q) explained += x * x;
    }
    rest_ = std::sqrt(std::max(0.0, cost - explained));
  }

  bool finite() const { return finite_; }
  double rest() const { return rest_; }
  /// Row of a variable, from its pose's x to the dt of the pose after the next one.
  const double* row(std::size_t v) const { return factor_.rows[v / 4][v % 4].data(); }
  double residual(std::size_t v) const { return residuals_[v / 4][v % 4]; }

 private:
  static constexpr double kRegular = 1e-11;

  const Band& band_;
  BandEvaluation& evaluation_;
  NormalEquations& equations_;
  BandFactor factor_;
  BandVector residuals_;
  double rest_ = 0.0;
  bool finite_ = true;
  bool at_start_ = true;
};

// Variables [begin, end) of the band, counted from x of the start.
struct Range {
  std::size_t begin = 0;
  std::size_t end = 0;

  std::size_t size() const { return end - begin; }
};

// Rows of R, over the parameter blocks they reach into; with the first ones, what is left of the cost.
class RootFunction final : public ceres::CostFunction {
 public:
  RootFunction(const SquareRoot& root, const std::vector<Range>& blocks, std::size_t first)
      : root_(root), rows_(blocks[first]), with_rest_(first == 0) {
    set_num_residuals(static_cast<int>(rows_.size() + with_rest_));
    const std::size_t last_reached = (rows_.end - 1) / 4 * 4 + kReach;
    for (std::size_t b = first; b < blocks.size() && blocks[b].begin < last_reached; ++b) {
      columns_.push_back(blocks[b]);
      mutable_parameter_block_sizes()->push_back(static_cast<int>(blocks[b].size()));
    }
  }

  std::size_t blocks() const { return columns_.size(); }

  bool Evaluate(double const* const*, double* residuals, double** jacobians) const override {
    if (!root_.finite()) return false;
    if (with_rest_) residuals[rows_.size()] = root_.rest();
    if (jacobians == nullptr) {
      std::fill_n(residuals, rows_.size(), 0.0);
      return true;
    }
    for (std::size_t v = rows_.begin; v < rows_.end; ++v) residuals[v - rows_.begin] = root_.residual(v);
    for (std::size_t b = 0; b < columns_.size(); ++b) write(columns_[b], jacobians[b]);
    return true;
  }

 private:
  static constexpr std::size_t kReach = 12;  // a row ends with the pose after the next one

  void write(const Range& columns, double* jacobian) const {
    std::fill_n(jacobian, columns.size() * (rows_.size() + with_rest_), 0.0);
    for (std::size_t v = rows_.begin; v < rows_.end; ++v, jacobian += columns.size()) {
      const std::size_t first = v / 4 * 4;  // column of the row's first value
      const std::size_t begin = std::max(columns.begin, first);
      const std::size_t end = std::min(columns.end, first + kReach);
      if (begin >= end) continue;
      std::copy_n(root_.row(v) + (begin - first), end - begin, jacobian + (begin - columns.begin));
    }
  }

  const SquareRoot& root_;
  Range rows_;
  bool with_rest_;
  std::vector<Range> columns_;
};

// All free variables: dt of the start to dt of the last pose but one, without a gap in memory.
std::vector<Range> parameter_blocks(std::size_t poses) {
  const std::size_t end = 4 * (poses - 1);
  std::vector<Range> blocks;
  for (std::size_t begin = 3; begin < end; begin = blocks.back().end) {
    blocks.push_back({begin, std::min(end, begin / kBlock * kBlock + kBlock)});
  }
  return blocks;
}

// Ends a solve that is lost, or has spent its iterations.
class Watch final : public ceres::IterationCallback {
 public:
  Watch(const SolveLimits& limits, double cost) : progress_(limits, cost) {}

  ceres::CallbackReturnType operator()(const ceres::IterationSummary& last) override {
    if (last.iteration == 0) return ceres::SOLVER_CONTINUE;
    // Ceres has half of the sum of the squares.
    const double gain = last.step_is_successful ? 2.0 * last.cost_change : 0.0;
    return progress_.ends(2.0 * last.cost, gain) ? ceres::SOLVER_TERMINATE_SUCCESSFULLY
                                                 : ceres::SOLVER_CONTINUE;
  }

 private:
  SolveProgress progress_;
};

ceres::Solver::Options solver_options(const SolveLimits& limits, double radius) {
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
  solver.max_num_iterations = limits.max_iterations + limits.overtime;
  solver.function_tolerance = limits.function_tolerance;
  solver.gradient_tolerance = 1e-8;
  solver.parameter_tolerance = 0.0;  // relative to the coordinates: it would ask less far from the origin
  return solver;
}

}  // namespace

SolveReport solve_with_ceres(Band& band, BandEvaluation& evaluation, NormalEquations& equations,
                             const SolveLimits& limits) {
  SquareRoot root(band, evaluation, equations);
  ceres::Problem::Options options;
  options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.disable_all_safety_checks = true;
  options.evaluation_callback = &root;
  ceres::Problem problem(options);
  const std::vector<Range> ranges = parameter_blocks(band.size());
  std::deque<RootFunction> functions;
  std::vector<double*> blocks;
  for (std::size_t b = 0; b < ranges.size(); ++b) {
    const RootFunction& function = functions.emplace_back(root, ranges, b);
    blocks.clear();
    for (std::size_t i = 0; i < function.blocks(); ++i)
      blocks.push_back(&band.poses[0].x + ranges[b + i].begin);
    problem.AddResidualBlock(&functions.back(), nullptr, blocks);
  }
  ceres::Solver::Summary summary;
  ceres::Solver::Options solver = solver_options(limits, band.trust_radius);
  Watch watch(limits, evaluation.cost().total());
  solver.callbacks.push_back(&watch);
  ceres::Solve(solver, &problem, &summary);
  SolveReport report;
  report.usable = summary.IsSolutionUsable();
  report.converged = summary.termination_type == ceres::CONVERGENCE;
  if (summary.iterations.empty()) return report;
  report.iterations = static_cast<int>(summary.iterations.size()) - 1;
  band.trust_radius = summary.iterations.back().trust_region_radius;
  return report;
}

}  // namespace bw::teb
