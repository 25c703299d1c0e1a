// What one band costs, by both solvers in turns and from the same bands: a first plan (cold), and the twenty
// cycles after it (warm, per cycle). Counters: time of each, their ratio, iterations, and the sum of the
// final costs. BM_Floor is what is left of a solve by Ceres when evaluation costs nothing: the same blocks,
// rows copied, ten iterations.
// All times are CPU time.
#include <ctime>

#include <benchmark/benchmark.h>
#include <ceres/ceres.h>

#include "tests/components/local_planner/band_scenes.hpp"

namespace bw::teb {
namespace {

double cpu_us() {
  timespec used{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return 1e6 * static_cast<double>(used.tv_sec) + 1e-3 * static_cast<double>(used.tv_nsec);
}

struct Cycle {
  Band band;
  BandScene scene;
  ObstacleField field;
};

// Bands to be optimised, each with what is around it: the first plan alone, or the cycles after it.
std::vector<Cycle> cycles(const BandTestScene& scene, const BandOptions& options, bool warm) {
  BandDrive drive(scene, options);
  std::vector<Cycle> list;
  for (int cycle = 0; cycle <= (warm ? 20 : 0); ++cycle) {
    Band band = drive.next();
    if (warm == (cycle > 0)) list.push_back({band, drive.scene_now, *drive.scene_now.obstacles});
    optimize(band, drive.scene_now, options, 1000);
    drive.band = band;
  }
  for (Cycle& cycle : list) cycle.scene.obstacles = &cycle.field;
  return list;
}

struct Sum {
  double us = 0.0;
  double cost = 0.0;
  double iterations = 0.0;

  void add(const Cycle& cycle, BandOptions options, Solver solver) {
    options.solver = solver;
    Band band = cycle.band;
    const double before = cpu_us();
    const BandReport report = optimize(band, cycle.scene, options, 1000);
    us += cpu_us() - before;
    cost += report.cost;
    iterations += report.iterations;
  }
};

void BM_Band(benchmark::State& state) {
  const BandTestScene scene = band_scenes()[static_cast<std::size_t>(state.range(0))];
  const BandOptions options = point_options();
  const std::vector<Cycle> list = cycles(scene, options, state.range(1) != 0);
  Sum ceres, banded;
  for (auto _ : state) {
    const double before = ceres.us + banded.us;
    for (const Cycle& cycle : list) {
      ceres.add(cycle, options, Solver::ceres);
      banded.add(cycle, options, Solver::banded);
    }
    state.SetIterationTime(1e-6 * (ceres.us + banded.us - before));
  }
  const double runs = static_cast<double>(state.iterations()) * static_cast<double>(list.size());
  state.SetLabel(scene.name + (state.range(1) != 0 ? ", warm, " : ", cold, ") +
                 std::to_string(list.front().band.size()) + " poses");
  state.counters["ceres_us"] = ceres.us / runs;
  state.counters["banded_us"] = banded.us / runs;
  state.counters["ratio"] = ceres.us / banded.us;
  state.counters["ceres_it"] = ceres.iterations / runs;
  state.counters["banded_it"] = banded.iterations / runs;
  state.counters["ceres_cost"] = ceres.cost / runs;
  state.counters["banded_cost"] = banded.cost / runs;
}

constexpr int kVariables = 8;  // of a block: two poses

// The cost falls by a tenth with each evaluation, so that every step is taken.
class Falling final : public ceres::EvaluationCallback {
 public:
  void PrepareForEvaluation(bool, bool new_evaluation_point) override {
    if (new_evaluation_point) scale_ *= 0.95;
  }
  double scale() const { return scale_; }

 private:
  double scale_ = 1.0;
};

// Eight rows over one block or two, upper triangular as the factor of a band is.
class Rows final : public ceres::CostFunction {
 public:
  Rows(const Falling& falling, int blocks) : falling_(falling) {
    set_num_residuals(kVariables);
    mutable_parameter_block_sizes()->assign(static_cast<std::size_t>(blocks), kVariables);
    for (int i = 0; i < kVariables; ++i) {
      for (int j = 0; j < kVariables; ++j) rows_[0][i * kVariables + j] = j < i ? 0.0 : i == j ? 10.0 : 1.0;
      for (int j = 0; j < kVariables; ++j) rows_[1][i * kVariables + j] = i < 4 && j >= 4 ? 0.0 : 1.0;
    }
  }

  bool Evaluate(double const* const*, double* residuals, double** jacobians) const override {
    std::fill_n(residuals, kVariables, falling_.scale());
    if (jacobians == nullptr) return true;
    for (std::size_t b = 0; b < parameter_block_sizes().size(); ++b) {
      std::copy_n(rows_[b], kVariables * kVariables, jacobians[b]);
    }
    return true;
  }

 private:
  const Falling& falling_;
  double rows_[2][kVariables * kVariables];
};

void BM_Floor(benchmark::State& state) {
  const auto blocks = static_cast<std::size_t>(state.range(0)) / 2;  // two poses each
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
  options.logging_type = ceres::SILENT;
  options.jacobi_scaling = false;
  options.min_lm_diagonal = options.max_lm_diagonal = 1.0;
  options.max_num_iterations = 10;
  double iterations = 0.0;
  for (auto _ : state) {
    std::vector<double> variables(blocks * kVariables, 1.0);
    Falling falling;
    ceres::Problem::Options ownership;
    ownership.disable_all_safety_checks = true;
    ownership.evaluation_callback = &falling;
    ceres::Problem problem(ownership);
    for (std::size_t b = 0; b < blocks; ++b) {
      std::vector<double*> reached{&variables[b * kVariables]};
      if (b + 1 < blocks) reached.push_back(&variables[(b + 1) * kVariables]);
      problem.AddResidualBlock(new Rows(falling, static_cast<int>(reached.size())), nullptr, reached);
    }
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    iterations += static_cast<double>(summary.iterations.size()) - 1.0;
  }
  state.counters["iterations"] = iterations / static_cast<double>(state.iterations());
}

BENCHMARK(BM_Band)
    ->ArgsProduct({{0, 1, 2, 3}, {0, 1}})
    ->ArgNames({"scene", "warm"})
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Floor)->Arg(48)->Arg(64)->Arg(96)->ArgName("poses")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace bw::teb

BENCHMARK_MAIN();
