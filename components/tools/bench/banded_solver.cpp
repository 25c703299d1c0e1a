#include "components/tools/bench/banded_solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace bw::teb {
namespace {

constexpr std::size_t kWidth =
    12;  // a variable shares residuals with the 11 before and after it: three poses of four
constexpr double kLargestDamping = 1e12;

// Normal equations H x = -g: row i of the lower triangle holds H(i, i - 11 .. i), the diagonal last.
struct NormalEquations {
  explicit NormalEquations(std::size_t size) : rows(size), gradient(size) {}

  double& at(std::size_t i, std::size_t j) { return rows[i][kWidth - 1 - (i - j)]; }
  double at(std::size_t i, std::size_t j) const { return rows[i][kWidth - 1 - (i - j)]; }

  std::vector<std::array<double, kWidth>> rows;
  std::vector<double> gradient;
};

bool is_free(std::size_t variable, std::size_t poses) {
  const std::size_t pose = variable / 4;
  return pose + 1 < poses && (pose > 0 || variable % 4 == 3);
}

// Adds J'J and J'r of one residual over `count` variables from `first` on.
void add(NormalEquations& equations, std::size_t first, const double* J, std::size_t count, double residual) {
  for (std::size_t a = 0; a < count && first + a < equations.gradient.size(); ++a) {
    if (J[a] == 0.0) continue;
    equations.gradient[first + a] += J[a] * residual;
    for (std::size_t b = 0; b <= a; ++b) equations.at(first + a, first + b) += J[a] * J[b];
  }
}

NormalEquations linearise(const Band& band, const BandProblem& problem) {
  NormalEquations equations(4 * band.size());
  double r[kSegmentResiduals];
  double J[kSegmentResiduals * kSegmentColumns];
  for (std::size_t k = 0; k < problem.segments(); ++k) {
    if (!evaluate_segment(problem.segment_model, problem.segment(k, band.poses.data()), r, J)) continue;
    for (std::size_t i = 0; i < kSegmentResiduals; ++i)
      add(equations, 4 * k, J + i * kSegmentColumns, kSegmentColumns, r[i]);
    const auto add_term = [&](const ClearanceTerm& term) {
      const double s = term.fraction;
      const Vector2 p = (1.0 - s) * band.poses[k].position() + s * band.poses[k + 1].position();
      Vector2 gradient;
      const double residual = evaluate_clearance(problem.clearance_model, term, p, &gradient);
      const double row[8] = {(1.0 - s) * gradient.x(), (1.0 - s) * gradient.y(), 0, 0,
                             s * gradient.x(),         s * gradient.y(),         0, 0};
      add(equations, 4 * k, row, 8, residual);
    };
    for (const ClearanceTerm& term : problem.terms[k].at_pose) add_term(term);
    for (const ClearanceTerm& term : problem.terms[k].along_segment) add_term(term);
  }
  for (std::size_t i = 0; i < equations.gradient.size(); ++i) {
    if (is_free(i, band.size())) continue;
    equations.gradient[i] = 0.0;
    for (std::size_t j = i < kWidth ? 0 : i - kWidth + 1; j <= i; ++j) equations.at(i, j) = 0.0;
    for (std::size_t j = i + 1; j < std::min(i + kWidth, equations.gradient.size()); ++j)
      equations.at(j, i) = 0.0;
    equations.at(i, i) = 1.0;
  }
  return equations;
}

// x of (H + damping I) x = -g by a banded Cholesky factorisation; false when not positive definite.
bool step_of(const NormalEquations& equations, double damping, std::vector<double>& x) {
  NormalEquations L = equations;
  const std::size_t n = L.gradient.size();
  const auto first = [](std::size_t i) { return i < kWidth ? std::size_t{0} : i - kWidth + 1; };
  x.assign(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    L.at(i, i) += damping;
    for (std::size_t j = first(i); j <= i; ++j) {
      double sum = L.at(i, j);
      for (std::size_t k = std::max(first(i), first(j)); k < j; ++k) sum -= L.at(i, k) * L.at(j, k);
      if (j < i) {
        L.at(i, j) = sum / L.at(j, j);
      } else {
        if (!(sum > 0.0)) return false;
        L.at(i, i) = std::sqrt(sum);
      }
    }
    double y = -L.gradient[i];
    for (std::size_t j = first(i); j < i; ++j) y -= L.at(i, j) * x[j];
    x[i] = y / L.at(i, i);
  }
  for (std::size_t i = n; i-- > 0;) {
    x[i] /= L.at(i, i);
    for (std::size_t j = first(i); j < i; ++j) x[j] -= L.at(i, j) * x[i];
  }
  return true;
}

}  // namespace

BandedReport solve_banded(Band& band, const BandProblem& problem, int max_iterations,
                          double function_tolerance) {
  BandedReport report;
  report.cost = problem.cost(band.poses.data()).total();
  double damping = 1e-5 * problem.largest_information();
  if (band.trust_radius > 0.0) damping = std::clamp(1.0 / band.trust_radius, 1e-3, damping);
  double growth = 2.0;
  NormalEquations equations = linearise(band, problem);
  std::vector<double> step;
  std::vector<BandPose> trial;
  for (; report.iterations < max_iterations && damping < kLargestDamping; ++report.iterations) {
    double cost = INFINITY;
    double predicted = 0.0;
    if (step_of(equations, damping, step)) {
      trial = band.poses;
      for (std::size_t i = 0; i < step.size(); ++i) {
        if (!is_free(i, band.size())) continue;
        BandPose& pose = trial[i / 4];
        (i % 4 == 0 ? pose.x : i % 4 == 1 ? pose.y : i % 4 == 2 ? pose.theta : pose.dt) += step[i];
        predicted += step[i] * (damping * step[i] - equations.gradient[i]);
      }
      cost = problem.cost(trial.data()).total();
    }
    const double gain = report.cost - cost;
    if (!(gain > 0.0)) {
      damping *= growth;
      growth *= 2.0;
      continue;
    }
    band.poses.swap(trial);
    const double ratio = gain / predicted;
    damping *= std::max(1.0 / 3.0, 1.0 - std::pow(2.0 * ratio - 1.0, 3.0));
    growth = 2.0;
    report.converged = gain < function_tolerance * report.cost;
    report.cost = cost;
    if (report.converged) break;
    equations = linearise(band, problem);
  }
  band.trust_radius = 1.0 / damping;
  return report;
}

BandReport optimize_banded(Band& band, const BandScene& scene, const BandOptions& options) {
  BandReport report;
  const bool warm = band.trust_radius > 0.0;
  const int outer = warm ? options.warm_outer_iterations : options.no_outer_iterations;
  const int inner = warm ? options.warm_inner_iterations : options.no_inner_iterations;
  double growth = 1.0;
  for (int i = 0; i < outer; ++i, growth *= warm ? 1.0 : options.weight_adapt_factor) {
    resize(band, options);
    const BandProblem problem(band, scene, options, growth);
    const BandedReport solved = solve_banded(band, problem, inner, options.function_tolerance);
    report.iterations += solved.iterations;
    report.cost = solved.cost;
  }
  report.usable = band.is_finite();
  for (BandPose& pose : band.poses) pose.theta = wrap_angle(pose.theta);
  return report;
}

}  // namespace bw::teb
