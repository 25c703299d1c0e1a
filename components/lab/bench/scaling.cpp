#include "components/lab/bench/scaling.hpp"

#include <algorithm>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "components/lab/bench/bench_common.hpp"
#include "components/local_planner/footprint_check.hpp"
#include "components/local_planner/planner_registry.hpp"
#include "components/local_planner/teb/band_optimizer.hpp"
#include "components/local_planner/teb/teb_options.hpp"
#include "components/model/differential_drive.hpp"
#include "runtime/base/quantile.hpp"
#include "runtime/process_memory.hpp"

namespace bw {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kWarmCycles = 10;
constexpr int kObstaclesWithoutLimits = 100;
constexpr double kTimeout = 60.0;  // [s]
constexpr double kArrived = 0.3;   // [m]
constexpr int kEnoughIterations = 1000;

template <class Call>
double cpu_ms_of(Call&& call) {
  const double before = process_cpu_ms();
  call();
  return process_cpu_ms() - before;
}

void follow(PlanningProblem& problem, const PlanningResult& result) {
  const double period = problem.control_period;
  problem.twist = result.command;
  problem.pose = advance_exact(problem.pose, result.command, period);
  problem.now = problem.now + Duration::seconds(period);
  for (Mover& mover : problem.movers) mover.position += period * mover.velocity;
}

struct Samples {
  std::vector<double> field, cold_band, warm_band, cold_cycle, warm_cycle, cost, free_cost, left_out;
};

void time_band(const PlanningProblem& problem, Samples& samples) {
  const teb::BandOptions options;
  teb::ObstacleField field;
  samples.field.push_back(cpu_ms_of([&] {
    field = teb::field_of(problem.obstacles, problem.movers, problem.pose.position(), problem.footprint);
  }));
  teb::Band band = teb::band_along(problem.plan, problem.pose, problem.limits, options);
  const teb::BandScene scene{problem.limits, problem.twist, true, &field};
  const auto optimize = [&] { teb::optimize(band, scene, options, kEnoughIterations); };
  samples.cold_band.push_back(cpu_ms_of(optimize));
  samples.warm_band.push_back(cpu_ms_of(optimize));
}

double chosen_cost(const PlanningResult& result) {
  for (const Candidate& candidate : result.candidates) {
    if (candidate.chosen) return candidate.cost;
  }
  return 0.0;
}

/// The last result of a planner that is called `1 + kWarmCycles` times.
PlanningResult time_cycles(PlanningProblem problem, LocalPlanner& planner, std::vector<double>& cold,
                           std::vector<double>& warm) {
  PlanningResult result;
  for (int cycle = 0; cycle <= kWarmCycles; ++cycle) {
    if (cycle > 0) follow(problem, result);
    (cycle == 0 ? cold : warm).push_back(cpu_ms_of([&] { result = planner.plan(problem); }));
  }
  return result;
}

double drive_time(PlanningProblem problem, LocalPlanner& planner, bool& arrived) {
  double time = 0.0;
  for (; time < kTimeout; time += problem.control_period) {
    follow(problem, planner.plan(problem));
    if (gap_at(problem.pose, 0.0, problem.footprint, problem.obstacles, problem.movers) < 0.0)
      return kTimeout;
    arrived = (problem.pose.position() - problem.plan.back().position()).norm() < kArrived;
    if (arrived) break;
  }
  return time;
}

struct Sweep {
  Crowding crowding;
  const char* name;
  std::vector<int> counts;
};

Json print_sweep(const Sweep& sweep, const std::string& planner, int repetitions) {
  std::printf("%s, %s\n  %6s %9s %14s %14s %14s %14s %9s %9s %8s %6s\n", sweep.name, planner.c_str(), "count",
              "field ms", "band cold", "warm", "cycle cold", "warm", "cost", "no limits", "left out", "MB");
  Json rows = Json::array();
  const std::vector<ScalingRow> measured =
      measure_scaling(sweep.crowding, sweep.counts, planner, repetitions);
  const ScalingRow& least = measured.front();
  for (const ScalingRow& r : measured) {
    std::printf("  %6d %9.3f %7.3f x%5.2f %7.3f x%5.2f %7.3f x%5.2f %7.3f x%5.2f %9.4f %9.4f %8.1f %6.1f\n",
                r.count, r.field_ms, r.cold_band_ms, r.cold_band_ms / least.cold_band_ms, r.warm_band_ms,
                r.warm_band_ms / least.warm_band_ms, r.cold_cycle_ms, r.cold_cycle_ms / least.cold_cycle_ms,
                r.warm_cycle_ms, r.warm_cycle_ms / least.warm_cycle_ms, r.cost, r.cost_without_limits,
                r.left_out, peak_memory_mb());
    rows.push_back({{"count", r.count},
                    {"field_ms", r.field_ms},
                    {"cold_band_ms", r.cold_band_ms},
                    {"warm_band_ms", r.warm_band_ms},
                    {"cold_cycle_ms", r.cold_cycle_ms},
                    {"warm_cycle_ms", r.warm_cycle_ms},
                    {"cost", r.cost},
                    {"cost_without_limits", r.cost_without_limits},
                    {"obstacles_left_out", r.left_out},
                    {"peak_memory_mb", peak_memory_mb()}});
  }
  return {{"what", sweep.name}, {"planner", planner}, {"rows", std::move(rows)}};
}

Json print_drives(const std::string& planner, int drives) {
  Json rows = Json::array();
  std::printf("drives through the corridor of points, %s\n", planner.c_str());
  for (const ScalingDrives& d : drive_corridors({200, 500, 1000, 2000}, planner, drives)) {
    std::printf("  %6d points: %d of %d arrive, mean %.2f s, slowest %.3f of the drive with 200\n", d.count,
                d.arrived, d.drives, d.mean_time, d.slowest);
    rows.push_back({{"count", d.count},
                    {"drives", d.drives},
                    {"arrived", d.arrived},
                    {"mean_time_s", d.mean_time},
                    {"slowest_ratio", d.slowest}});
  }
  return {{"planner", planner}, {"rows", std::move(rows)}};
}

}  // namespace

std::vector<ScalingRow> measure_scaling(Crowding crowding, const std::vector<int>& counts,
                                        const std::string& planner, int repetitions) {
  std::vector<Samples> samples(counts.size());
  PlannerOptions without_limits;
  without_limits.of<teb::TebOptions>("teb").band.max_obstacles_per_pose = kObstaclesWithoutLimits;
  std::vector<double> not_reported;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const PlanningProblem problem =
          crowded(crowding, counts[i], static_cast<std::uint64_t>(repetition) + 1);
      Samples& s = samples[i];
      time_band(problem, s);
      const PlanningResult last =
          time_cycles(problem, *make_planner(planner, {}), s.cold_cycle, s.warm_cycle);
      s.cost.push_back(chosen_cost(last));
      s.left_out.push_back(static_cast<double>(last.obstacles_left_out));
      s.free_cost.push_back(chosen_cost(
          time_cycles(problem, *make_planner(planner, without_limits), not_reported, not_reported)));
    }
  }
  std::vector<ScalingRow> rows;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const Samples& s = samples[i];
    rows.push_back({counts[i], quantile(s.field, 0.5), quantile(s.cold_band, 0.5), quantile(s.warm_band, 0.5),
                    quantile(s.cold_cycle, 0.5), quantile(s.warm_cycle, 0.5), mean(s.cost), mean(s.free_cost),
                    mean(s.left_out)});
  }
  return rows;
}

std::vector<ScalingDrives> drive_corridors(const std::vector<int>& counts, const std::string& planner,
                                           int drives) {
  std::vector<ScalingDrives> rows;
  std::vector<double> first_times;
  for (const int count : counts) {
    ScalingDrives row{.count = count, .drives = drives};
    for (int i = 0; i < drives; ++i) {
      const PlanningProblem problem = crowded(Crowding::points, count, static_cast<std::uint64_t>(i) + 1);
      bool arrived = false;
      const double time = drive_time(problem, *make_planner(planner, {}), arrived);
      if (static_cast<int>(first_times.size()) < drives) first_times.push_back(time);
      row.arrived += arrived ? 1 : 0;
      row.mean_time += time / drives;
      row.slowest = std::max(row.slowest, time / first_times[static_cast<std::size_t>(i)]);
    }
    rows.push_back(row);
  }
  return rows;
}

int bench_scaling(const BenchScalingArguments& arguments) {
  const std::vector<Sweep> sweeps = {
      {Crowding::points, "static points along a corridor of 12 m", {10, 30, 100, 300, 1000, 3000, 10000}},
      {Crowding::corridor, "walkers in the corridor", {0, 5, 10, 20}},
      {Crowding::hall, "walkers in a hall of 100 x 100 m", {0, 20, 100, 500}}};
  Json measured = Json::array(), drives = Json::array();
  for (const std::string& planner : arguments.planners) {
    for (const Sweep& sweep : sweeps) measured.push_back(print_sweep(sweep, planner, arguments.repetitions));
    if (arguments.drives > 0) drives.push_back(print_drives(planner, arguments.drives));
  }
  write_json(arguments.json, {{"scaling", std::move(measured)}, {"drives", std::move(drives)}});
  return 0;
}

}  // namespace bw
