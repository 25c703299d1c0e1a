// CPU time of one sweep in the detector: 720 beams over 270 degrees, 20 people, about 200 clusters, robot
// moving.
#include <cmath>
#include <numbers>
#include <vector>

#include <benchmark/benchmark.h>

#include "components/people/detector/detector.hpp"
#include "components/world/laser_scanner.hpp"

namespace bw::people {
namespace {

constexpr int kPeople = 20;
constexpr int kSweeps = 50;

struct Recorded {
  std::vector<Pose2> poses;
  std::vector<LaserScan> scans;
  LaserOptions laser;
  OccupancyGrid map;
};

/// A round hall of 10 m radius in which people walk in circles; or, `splintered`, the wall behind them broken
/// into pieces of two beams, every other one 0.4 m nearer.
Recorded record(bool splintered) {
  Recorded recorded;
  recorded.laser.range_max = 20.0;
  recorded.laser.range_noise = 0.02;
  StaticObstacles shapes;
  for (int i = 0; i < 40; ++i) {
    const double from = 2.0 * std::numbers::pi * i / 40;
    const double to = 2.0 * std::numbers::pi * (i + 1) / 40;
    shapes.segments.push_back({10.0 * direction(from), 10.0 * direction(to)});
  }
  const StaticScene scene(shapes, std::nullopt);
  LaserScanner scanner(recorded.laser, Random(4));
  for (int s = 0; s < kSweeps; ++s) {
    std::vector<Disc> legs;
    for (int i = 0; i < kPeople; ++i) {
      const double angle = 4.5 * (i - 9.5) / kPeople + 0.01 * s;
      const Vector2 middle = (2.0 + 0.2 * (i % 10)) * direction(angle);
      const Vector2 side = 0.15 * direction(angle + 1.0 + 0.3 * s);
      legs.push_back({middle + side, 0.07});
      legs.push_back({middle - side, 0.07});
    }
    recorded.poses.push_back({0.02 * s, 0.0, 0.005 * s});
    recorded.scans.push_back(scanner.scan(scene, legs, recorded.poses.back()));
    std::vector<float>& ranges = recorded.scans.back().ranges;
    for (std::size_t i = 0; splintered && i < ranges.size(); ++i) {
      if (ranges[i] > 6.0F) ranges[i] = i / 2 % 2 == 0 ? 7.0F : 7.4F;
    }
  }
  recorded.map = {0.05, {-12.0, -12.0}, 480, 480, std::vector<std::int8_t>(480 * 480, 0)};
  return recorded;
}

void BM_Detect(benchmark::State& state) {
  const Recorded recorded = record(state.range(0) != 0);
  Detector detector(DetectorOptions{});
  const std::vector<Vector2> people(kPeople, Vector2(3.0, 0.0));
  std::size_t sweeps = 0;
  std::size_t clusters = 0;
  for (auto _ : state) {
    const std::size_t s = sweeps % kSweeps;
    const LaserScan& scan = recorded.scans[s];
    const LaserSweep sweep{Time::seconds(0.1 * static_cast<double>(sweeps)),
                           recorded.poses[s],
                           scan.angle_min,
                           scan.angle_increment,
                           recorded.laser.range_min,
                           recorded.laser.range_max,
                           scan.ranges};
    clusters += detector.detect(sweep, {&recorded.map, Pose2{}, people}).detections.size();
    ++sweeps;
  }
  state.counters["clusters"] = static_cast<double>(clusters) / static_cast<double>(sweeps);
}

BENCHMARK(BM_Detect)->Arg(0)->Arg(1)->ArgName("splintered")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace bw::people

BENCHMARK_MAIN();
