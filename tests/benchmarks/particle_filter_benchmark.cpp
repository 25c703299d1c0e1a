// CPU time of whole updates of the particle filter: 0.26 m of wheels, one sweep of 60 beams, every particle
// drawn anew. Conditions of localization/evidence.md 9.2: 20 x 20 m, cells of 5 cm.
#include <numbers>

#include <benchmark/benchmark.h>

#include "components/localization/particle_filter/particle_filter.hpp"
#include "components/model/differential_drive.hpp"
#include "components/model/wheel_step.hpp"
#include "tests/components/localization/particle_filter_rooms.hpp"

namespace bw::localization {
namespace {

constexpr int kPositions = 48;  // of a circle of 2 m radius, 0.26 m apart

struct Sweep {
  Pose2 X_MB;
  LaserReading reading;
  std::vector<float> ranges;
};

std::vector<Sweep> drive_circle() {
  Sweeper sweeper(rooms());
  std::vector<Sweep> sweeps(kPositions);
  for (int i = 0; i < kPositions; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kPositions;
    Sweep& sweep = sweeps[static_cast<std::size_t>(i)];
    sweep.X_MB = {6.0 + 2.0 * std::cos(angle), 6.0 + 2.0 * std::sin(angle), angle + std::numbers::pi / 2.0};
    sweep.reading = sweeper.sweep({}, sweep.X_MB);
    sweep.ranges.assign(sweep.reading.ranges.begin(), sweep.reading.ranges.end());
  }
  return sweeps;
}

void update(benchmark::State& state, ParticleFilterOptions options, MotionNoise noise) {
  const std::vector<Sweep> sweeps = drive_circle();
  options.laser.update_min_d = options.laser.update_min_a = 0.0;
  options.motion.noise = noise;
  ParticleFilter filter(options);
  filter.set_map(rooms());
  Time now = Time::seconds(1000.0);
  filter.start_at(sweeps[0].X_MB, 0.01 * Eigen::Matrix3d::Identity(), now);
  std::size_t i = 0;
  double particles = 0.0;
  const Duration period = Duration::milliseconds(260);
  const double rotation = 2.0 * std::numbers::pi / kPositions;
  for ([[maybe_unused]] auto _ : state) {
    i = (i + 1) % sweeps.size();
    now = now + period;
    WheelStep step = step_from_twist(now, period, {2.0 * rotation / 0.26, rotation / 0.26},
                                     Eigen::Vector2d(0.01, 0.01).asDiagonal());
    filter.add(step, now);
    LaserReading reading = sweeps[i].reading;
    reading.time = now;
    reading.ranges = sweeps[i].ranges;
    filter.add(reading, now);
    particles += static_cast<double>(filter.particles()->size());
  }
  const Estimate e = filter.estimate_at(now);
  state.counters["particles"] = particles / static_cast<double>(state.iterations());
  state.counters["error_m"] = (e.X_MB.position() - sweeps[i].X_MB.position()).norm();
}

void FixedCount(benchmark::State& state) {
  ParticleFilterOptions options;
  options.count.min_particles = options.count.max_particles = static_cast<int>(state.range(0));
  options.resampling.n_eff_share = 1.0;
  update(state, options, MotionNoise::declared);
}
BENCHMARK(FixedCount)->Arg(500)->Arg(2000)->Arg(10000)->Arg(50000)->Unit(benchmark::kMicrosecond);

/// Without the search of the whole map that asks now and then whether another place fits better.
void FixedCountWithoutSearch(benchmark::State& state) {
  ParticleFilterOptions options;
  options.count.min_particles = options.count.max_particles = static_cast<int>(state.range(0));
  options.resampling.n_eff_share = 1.0;
  options.recovery.enabled = false;
  update(state, options, MotionNoise::declared);
}
BENCHMARK(FixedCountWithoutSearch)->Arg(2000)->Unit(benchmark::kMicrosecond);

/// With AMCL's motion noise and the count that the spread of the set asks for.
void AdaptiveCount(benchmark::State& state) {
  ParticleFilterOptions options;
  options.resampling.n_eff_share = 1.0;
  update(state, options, MotionNoise::amcl);
}
BENCHMARK(AdaptiveCount)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace bw::localization

BENCHMARK_MAIN();
