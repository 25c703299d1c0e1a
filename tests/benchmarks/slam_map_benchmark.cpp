// CPU time of a scan while a map of 200 x 200 m is published every 20 scans: as a whole on the same lane, or
// in tiles that another thread lays together (whose time is not counted).
#include <algorithm>
#include <ctime>
#include <vector>

#include <benchmark/benchmark.h>

#include "components/slam/map_rendering.hpp"
#include "components/slam/published_map.hpp"
#include "components/slam/slam.hpp"
#include "tests/components/slam/slam_scene.hpp"

namespace bw::slam {
namespace {

constexpr double kSide = 200.0;   // [m]
constexpr int kScansPerMap = 20;  // 2 s at 10 scans/s
constexpr std::size_t kTilesPerScan = 500;

/// Round scans of 12 m, 8 m apart: all of the square is known.
void draw_all(MapRendering& map) {
  RangeImage image;
  image.angle_min = -3.14159;
  image.angle_increment = 2.0 * 3.14159 / 1440.0;
  image.millimetres.assign(1440, 12000);
  for (double y = -0.5 * kSide + 12.0; y <= 0.5 * kSide - 12.0; y += 8.0)
    for (double x = -0.5 * kSide + 12.0; x <= 0.5 * kSide - 12.0; x += 8.0) map.draw(image, {x, y, 0.0});
}

/// Of this thread: a machine that does something else as well tells the same.
double cpu_milliseconds() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

struct Recorded {
  Scan scan;
  Pose2 X_OB;
};

/// Twice round four corridors, at 0.5 m/s: its own loops are closed on the way.
std::vector<Recorded> drive() {
  test::Scanner scanner(test::square_of_corridors(), 0.01, 1);
  const std::vector<Vector2> corners = {{-5, -4}, {5, -4}, {5, 4},  {-5, 4}, {-5, -4},
                                        {5, -4},  {5, 4},  {-5, 4}, {-5, -4}};
  std::vector<Recorded> scans;
  Time time;
  for (const Pose2& X : test::drive_along(corners, 0.05)) {
    scans.push_back({scanner.scan(time, X), X});
    time = time + Duration::milliseconds(100);
  }
  return scans;
}

enum class How { not_at_all, whole, tiles };

void HandleScan(benchmark::State& state) {
  const auto how = static_cast<How>(state.range(0));
  const std::vector<Recorded> scans = drive();
  std::vector<double> milliseconds;
  for ([[maybe_unused]] auto _ : state) {
    state.PauseTiming();
    milliseconds.clear();
    MapRendering map(0.05);
    PublishedMap published(0.05);
    draw_all(map);
    Slam slam(SlamOptions{});
    std::vector<MapTile> tiles;
    std::size_t to_gather = 0;
    state.ResumeTiming();
    for (std::size_t k = 0; k < scans.size(); ++k) {
      const double begin = cpu_milliseconds();
      const std::size_t nodes = slam.nodes().size();
      const Tracked tracked = slam.add(scans[k].scan, scans[k].X_OB);
      for (int i = 0; i < kPiecesPerScan && slam.advance(); ++i) {
      }
      if (slam.nodes().size() > nodes) map.draw(*slam.nodes().rbegin()->second.ranges, slam.pose(tracked.placement));
      const bool is_due = k % kScansPerMap == 0;
      if (how == How::whole && is_due) {
        const OccupancyGrid grid = map.grid();
        std::vector<std::int8_t> message(grid.cells.begin(), grid.cells.end());
        benchmark::DoNotOptimize(message.data());
      }
      bool is_gathered = false;
      if (how == How::tiles) {
        if (is_due) to_gather = map.changed_tiles();
        const std::size_t now = std::min(to_gather, kTilesPerScan);
        map.gather(now, tiles);
        is_gathered = to_gather > 0 && now == to_gather;
        to_gather -= now;
      }
      milliseconds.push_back(cpu_milliseconds() - begin);
      if (!is_gathered) continue;
      published.next(tiles);  // on the other thread
      tiles.clear();
    }
  }
  std::sort(milliseconds.begin(), milliseconds.end());
  state.counters["scans"] = static_cast<double>(milliseconds.size());
  state.counters["p50_ms"] = milliseconds[milliseconds.size() / 2];
  state.counters["p99_ms"] = milliseconds[milliseconds.size() * 99 / 100];
  state.counters["max_ms"] = milliseconds.back();
}
BENCHMARK(HandleScan)
    ->Arg(static_cast<int>(How::not_at_all))
    ->Arg(static_cast<int>(How::whole))
    ->Arg(static_cast<int>(How::tiles))
    ->ArgName("published")
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

// What the other thread does with one tile of 15,625 that changed.
void LayOneTile(benchmark::State& state) {
  MapRendering map(0.05);
  PublishedMap published(0.05);
  draw_all(map);
  std::vector<MapTile> tiles;
  map.gather(map.changed_tiles(), tiles);
  published.next(tiles);
  std::vector<MapTile> one = {tiles[tiles.size() / 2]};
  for ([[maybe_unused]] auto _ : state) {
    one[0].cells[0] = one[0].cells[0] == 0 ? 100 : 0;
    benchmark::DoNotOptimize(published.next(one));
  }
}
BENCHMARK(LayOneTile)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace bw::slam

BENCHMARK_MAIN();
