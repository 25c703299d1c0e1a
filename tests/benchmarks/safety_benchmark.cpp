// Cost of what looks at each command before the wheels: a cycle of the collision monitor (odometry, a sweep,
// a command), and a step of the velocity limiter. With and without checked containers (row 50 of
// tests/README.md): two build folders, one with -DBANDWAGON_CHECKED=. Figures are CPU time.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <benchmark/benchmark.h>

#include "components/motor_control/velocity_limiter.hpp"
#include "components/safety/collision_monitor.hpp"

namespace bw {
namespace {

constexpr int kBeams = 360;

/// A hallway of 6 m between its walls, and eight pairs of legs. Equal sweeps would be those of a laser that
/// is frozen: `noise` [m] is of all beams.
std::vector<float> hallway_ranges(float noise) {
  std::vector<float> ranges(kBeams);
  for (int i = 0; i < kBeams; ++i) {
    const double angle = -std::numbers::pi + i * 2.0 * std::numbers::pi / kBeams;
    ranges[static_cast<std::size_t>(i)] =
        static_cast<float>(std::min(10.0, 3.0 / std::max(1e-6, std::abs(std::sin(angle)))));
  }
  for (std::size_t leg = 0; leg < 16; ++leg) {
    const std::size_t first = 11 + 22 * leg;
    for (std::size_t i = first; i < first + 3; ++i) ranges[i] = 1.5F + 0.2F * static_cast<float>(leg);
  }
  for (float& range : ranges) range += noise;
  return ranges;
}

void cycle_of(benchmark::State& state, const Robot& robot) {
  safety::CollisionMonitor monitor(robot, {});
  const std::array sweeps{hallway_ranges(0.0F), hallway_ranges(0.002F)};
  std::size_t count = 0;
  Time now = Time::seconds(1.0);
  double x = 0.0;
  double slowest = 1.0;
  for (auto _ : state) {
    now = now + Duration::milliseconds(100);
    x += 0.05;
    monitor.odometry(now, {x, 0.0, 0.0}, {0.5, 0.1});
    monitor.sweep(now, {.time = now,
                        .X_FL = {},
                        .angle_min = -std::numbers::pi,
                        .angle_increment = 2.0 * std::numbers::pi / kBeams,
                        .range_min = 0.05,
                        .range_max = 12.0,
                        .ranges = sweeps[++count % 2]});
    slowest = std::min(slowest, monitor.judge(now, {0.5, 0.1}).allowed.v);
  }
  if (slowest <= 0.0) state.SkipWithError("the monitor lets nothing pass: it does not look ahead then");
}

void BM_MonitorCycleOfADisc(benchmark::State& state) { cycle_of(state, {}); }

void BM_MonitorCycleOfAPolygon(benchmark::State& state) {
  Robot robot;
  robot.footprint = "[[0.4, 0.25], [-0.4, 0.25], [-0.4, -0.25], [0.4, -0.25]]";
  cycle_of(state, robot);
}

void BM_LimiterStep(benchmark::State& state) {
  VelocityLimiter limiter({}, {});
  Time now = Time::seconds(1.0);
  for (auto _ : state) {
    now = now + Duration::milliseconds(20);
    limiter.command(now, {0.5, 0.3});
    benchmark::DoNotOptimize(limiter.step(now));
  }
}

BENCHMARK(BM_MonitorCycleOfADisc)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_MonitorCycleOfAPolygon)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_LimiterStep)->Unit(benchmark::kNanosecond);

}  // namespace
}  // namespace bw

BENCHMARK_MAIN();
