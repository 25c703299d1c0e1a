// CPU time of what the maps cost each cycle: obstacles of a window of 160 x 160 cells, and exact distance
// fields.
#include <benchmark/benchmark.h>

#include "components/mapping/obstacle_extraction.hpp"
#include "components/model/distance_transform.hpp"
#include "tests/components/global_planner/random_floor.hpp"

namespace bw {
namespace {

void ExtractObstacles(benchmark::State& state) {
  Random random(1);
  const OccupancyGrid map = test::random_floor(random, 400);
  std::size_t shapes = 0;
  for ([[maybe_unused]] auto _ : state) {
    const Vector2 position = map.origin + Vector2{random.uniform(4.0, 16.0), random.uniform(4.0, 16.0)};
    const ExtractionResult result = extract_obstacles(map, position, {});
    shapes += result.obstacles.size();
  }
  const auto runs = static_cast<double>(state.iterations());
  state.counters["shapes"] = static_cast<double>(shapes) / runs;
}
BENCHMARK(ExtractObstacles)->Unit(benchmark::kMillisecond);

void DistanceField(benchmark::State& state) {
  Random random(1);
  const OccupancyGrid map = test::random_floor(random, static_cast<int>(state.range(0)));
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(distance_field(map, {}));
}
BENCHMARK(DistanceField)->Arg(200)->Arg(400)->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace bw

BENCHMARK_MAIN();
