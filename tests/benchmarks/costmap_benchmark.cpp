// CPU time of one cycle of the local costmap: a sweep of 720 beams into 200 x 200 cells with decay, costs
// with exact distances, and shapes for the planner. In the hallway among eight people, while the robot drives
// and the window rolls.
#include <benchmark/benchmark.h>

#include "components/mapping/costmap/inflation.hpp"
#include "components/mapping/costmap/local_grid.hpp"
#include "components/mapping/obstacle_extraction.hpp"
#include "tests/components/mapping/costmap_drive.hpp"
#include "tests/components/world/hallway.hpp"

namespace bw {
namespace {

struct Recorded {
  LaserScan scan;
  Pose2 X_OB;
  std::vector<Disc> people;
};

std::vector<Recorded> record() {
  test::CostmapDrive drive(hallway(), {}, 1);
  std::vector<Recorded> sweeps;
  for (int k = 0; k < 100; ++k) {
    drive.next_sweep({1.0, 0.3 * std::cos(0.08 * k)}, true);
    Recorded& sweep = sweeps.emplace_back();
    sweep.scan = drive.scan();
    sweep.X_OB = drive.X_OB();
    for (const Person& person : drive.world().people())
      sweep.people.push_back({inverse(drive.X_MO()) * person.position, person.radius});
  }
  return sweeps;
}

struct Cycle {
  std::vector<Recorded> sweeps = record();
  costmap::LocalGrid grid{{}};
  std::int64_t count = 0;

  void sweep() {
    const Recorded& r = sweeps[static_cast<std::size_t>(count) % sweeps.size()];
    ++count;
    grid.add({.time = Time::seconds(0.1 * static_cast<double>(count)),
              .X_FL = r.X_OB,
              .angle_min = r.scan.angle_min,
              .angle_increment = r.scan.angle_increment,
              .range_min = 0.05,
              .range_max = 20.0,
              .ranges = r.scan.ranges},
             r.X_OB, {0.3, {}}, r.people);
  }
  Vector2 robot() const { return grid.cells().origin + Vector2(5.0, 5.0); }
};

void Sweep(benchmark::State& state) {
  Cycle cycle;
  for ([[maybe_unused]] auto _ : state) cycle.sweep();
}
BENCHMARK(Sweep)->Unit(benchmark::kMillisecond);

void DistanceAndInflation(benchmark::State& state) {
  Cycle cycle;
  for (int k = 0; k < 50; ++k) cycle.sweep();
  costmap::Inflation inflation({}, 0.3, 0.05);
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(inflation.costs(cycle.grid.cells()).data());
}
BENCHMARK(DistanceAndInflation)->Unit(benchmark::kMillisecond);

void WholeCycle(benchmark::State& state) {
  Cycle cycle;
  costmap::Inflation inflation({}, 0.3, 0.05);
  for ([[maybe_unused]] auto _ : state) {
    cycle.sweep();
    benchmark::DoNotOptimize(inflation.costs(cycle.grid.cells()).data());
    benchmark::DoNotOptimize(
        extract_obstacles(cycle.grid.cells(), cycle.robot(), {.tolerance_cells = 0.3}, cycle.grid.surface()));
  }
}
BENCHMARK(WholeCycle)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace bw

BENCHMARK_MAIN();
