// CPU time of localization by laser: weights of particles, the field of a map, and the search of the whole
// map.
#include <benchmark/benchmark.h>

#include "components/localization/laser/laser_model.hpp"
#include "components/localization/laser/pose_search.hpp"
#include "tests/components/localization/laser_robot.hpp"
#include "tests/components/localization/laser_scene.hpp"

namespace bw::localization {
namespace {

constexpr Pose2 kTruth{-2.0, -3.0, 0.7};

BeamEnds sixty_ends(const OccupancyGrid& map) {
  test::SensedRobot robot(map, {}, 1);
  return beam_ends(robot.sweep({}, kTruth), 60);
}

// Half a metre around a pose, as when tracking, or all over the map, as at a start anywhere.
void LogWeights(benchmark::State& state) {
  const OccupancyGrid map = test::repeated_rooms(1);
  const LikelihoodField field(map, {});
  const BeamEnds ends = sixty_ends(map);
  const bool anywhere = state.range(1) != 0;
  Random random(2);
  ParticleSet particles;
  particles.resize(static_cast<std::size_t>(state.range(0)));
  for (std::size_t i = 0; i < particles.size(); ++i) {
    particles.x[i] = anywhere ? random.uniform(-10.0, 10.0) : random.normal(kTruth.x, 0.15);
    particles.y[i] = anywhere ? random.uniform(-10.0, 10.0) : random.normal(kTruth.y, 0.15);
    particles.theta[i] = anywhere ? random.uniform(-3.1, 3.1) : random.normal(kTruth.theta, 0.05);
  }
  std::vector<double> log_weight(particles.size());
  for ([[maybe_unused]] auto _ : state) {
    add_log_weights(field, ends, particles, log_weight);
    benchmark::ClobberMemory();
  }
  state.counters["ends/s"] = benchmark::Counter(static_cast<double>(particles.size() * ends.size()),
                                                benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(LogWeights)
    ->ArgsProduct({{500, 2000, 50000}, {0, 1}})
    ->ArgNames({"particles", "anywhere"})
    ->Unit(benchmark::kMicrosecond);

void BuildField(benchmark::State& state) {
  const OccupancyGrid map = test::repeated_rooms(1);
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(LikelihoodField(map, {}));
}
BENCHMARK(BuildField)->Unit(benchmark::kMillisecond);

void BuildSearch(benchmark::State& state) {
  const LikelihoodField field(test::repeated_rooms(1), {});
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(PoseSearch(field, {}));
}
BENCHMARK(BuildSearch)->Unit(benchmark::kMillisecond);

void BeginSearch(benchmark::State& state) {
  const OccupancyGrid map = test::repeated_rooms(1);
  PoseSearch search(LikelihoodField(map, {}), {});
  const BeamEnds ends = sixty_ends(map);
  for ([[maybe_unused]] auto _ : state) search.begin(ends);
}
BENCHMARK(BeginSearch)->Unit(benchmark::kMicrosecond);

void Search(benchmark::State& state) {
  const OccupancyGrid map = test::repeated_rooms(1);
  PoseSearch search(LikelihoodField(map, {}), {});
  const BeamEnds ends = sixty_ends(map);
  for ([[maybe_unused]] auto _ : state) {
    search.begin(ends);
    while (!search.advance(10000)) continue;
  }
  state.counters["nodes"] = static_cast<double>(search.visited());
}
BENCHMARK(Search)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace bw::localization

BENCHMARK_MAIN();
