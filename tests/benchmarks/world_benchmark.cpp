// Cost of one laser scan and of one second of the hallway. Figures are CPU time.
#include <benchmark/benchmark.h>

#include "components/world/world.hpp"
#include "tests/components/world/hallway.hpp"

namespace bw {
namespace {

/// A 50 x 80 m floor of 0.05 m cells: walls round it, and pillars of 0.25 m strewn over `share` of a 2 m
/// raster.
OccupancyGrid big_map(double share) {
  OccupancyGrid grid{0.05, {0.0, 0.0}, 1000, 1600, std::vector<std::int8_t>(1'600'000, 0)};
  const auto fill = [&](int column, int row, int columns, int rows) {
    for (int r = row; r < row + rows; ++r) {
      for (int c = column; c < column + columns; ++c) grid.cells[grid.index(c, r)] = OccupancyGrid::kOccupied;
    }
  };
  fill(0, 0, 1000, 1);
  fill(0, 1599, 1000, 1);
  fill(0, 0, 1, 1600);
  fill(999, 0, 1, 1600);
  Random random(11);
  for (int row = 20; row < 1580; row += 40) {
    for (int column = 20; column < 980; column += 40) {
      if (random.uniform() < share) fill(column, row, 5, 5);
    }
  }
  return grid;
}

void scan(benchmark::State& state, const StaticScene& scene) {
  LaserOptions options;
  options.range_max = 30.0;
  LaserScanner laser(options, Random(1));
  std::vector<Disc> legs;
  legs.reserve(20);
  for (int i = 0; i < 20; ++i) legs.push_back({{20.0 + i, 40.0 + i % 7}, 0.07});
  double theta = 0.0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(laser.scan(scene, legs, {25.0, 40.0, theta}));
    theta += 0.1;
  }
}

void BM_ScanEmptyMap(benchmark::State& state) { scan(state, StaticScene({}, big_map(0.0))); }
void BM_ScanPillarMap(benchmark::State& state) {
  scan(state, StaticScene({}, big_map(static_cast<double>(state.range(0)) / 100.0)));
}
void BM_ScanSegments(benchmark::State& state) {
  Random random(12);
  StaticObstacles shapes;
  for (int i = 0; i < state.range(0); ++i) {
    const Vector2 a{random.uniform(0.0, 50.0), random.uniform(0.0, 80.0)};
    shapes.segments.push_back({a, a + random.uniform(0.5, 8.0) * direction(random.uniform(-3.14, 3.14))});
  }
  scan(state, StaticScene(shapes, std::nullopt));
}

void BM_HallwaySecond(benchmark::State& state) {
  World world(hallway(), Robot(), {}, 1);
  for (auto _ : state) {
    for (int i = 0; i < 100; ++i) {
      Duration time = world.step().time;
      benchmark::DoNotOptimize(time);
    }
  }
}

/// What a walker asks of the map every step: the nearest solid cell within 5.8 m.
void BM_NearestInMap(benchmark::State& state) {
  const StaticScene scene({}, big_map(static_cast<double>(state.range(0)) / 100.0));
  Random random(13);
  for (auto _ : state) {
    const Vector2 point{random.uniform(5.0, 45.0), random.uniform(5.0, 75.0)};
    benchmark::DoNotOptimize(scene.nearest_point(point, 5.8));
  }
}

void BM_BuildMap(benchmark::State& state) {
  const OccupancyGrid grid = big_map(0.1);
  for (auto _ : state) benchmark::DoNotOptimize(GridScene(grid));
}

BENCHMARK(BM_ScanEmptyMap)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ScanPillarMap)->Arg(2)->Arg(30)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ScanSegments)->Arg(12)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_HallwaySecond)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_NearestInMap)->Arg(0)->Arg(2)->Arg(30)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_BuildMap)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace bw

BENCHMARK_MAIN();
