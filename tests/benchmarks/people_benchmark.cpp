// CPU time of detector and tracker per sweep, at the most that issue 5.1 names: 720 beams, 20 people who walk
// among thin poles, 200 clusters. Asked: 5 ms in the worst sweep.
#include <algorithm>
#include <ctime>
#include <optional>
#include <vector>

#include <benchmark/benchmark.h>

#include "components/people/detector/detector.hpp"
#include "components/people/files/head_file.hpp"
#include "components/people/prediction/predictor.hpp"
#include "components/people/tracker/assignment.hpp"
#include "components/people/tracker/tracker.hpp"
#include "components/world/laser_scanner.hpp"
#include "components/world/legs.hpp"

namespace bw::people {
namespace {

struct Recorded {
  Time time;
  Pose2 X_OL;
  LaserScan scan;
};

/// A minute of a robot that rotates among people who walk round it, inside rings of poles. Many poles stand
/// as legs do and are taken for people: all the more to do.
std::vector<Recorded> crowded_minute(const LaserOptions& laser) {
  Random random(1);
  StaticObstacles poles;
  for (int i = 0; i < 310; ++i) {
    const double angle = 0.0203 * i;
    poles.discs.push_back({(4.6 + 0.7 * (i % 3)) * direction(angle), random.uniform(0.03, 0.06)});
  }
  const StaticScene scene(poles, std::nullopt);
  LaserScanner scanner(laser, Random(2));
  bw::Legs legs{bw::LegOptions{}};
  std::vector<Person> people(20);
  std::vector<Recorded> minute;
  for (int k = 0; k < 600; ++k) {
    for (int step = 0; step < 10; ++step) {
      const double t = 0.1 * k + 0.01 * step;
      for (std::size_t i = 0; i < people.size(); ++i) {
        const double start = 0.314 * static_cast<double>(i);
        const double range = 2.2 + 0.12 * static_cast<double>(i);
        const double rate = (i % 2 == 0 ? 1.0 : -1.0) / range;
        people[i].id = static_cast<std::uint32_t>(i + 1);
        people[i].position = range * direction(start + rate * t);
        people[i].velocity = rate * range * direction(start + rate * t + 1.5708);
      }
      legs.step(0.01, people);
    }
    const Pose2 X{0.3 * std::sin(0.1 * k), 0.0, wrap_angle(0.02 * k)};
    minute.push_back({Time::seconds(0.1 * (k + 1)), X, scanner.scan(scene, legs.discs(people), X)});
  }
  return minute;
}

double thread_milliseconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

void Sweep20People200Clusters(benchmark::State& state) {
  LaserOptions laser;
  laser.range_max = 10.0;
  laser.range_noise = 0.02;
  const std::vector<Recorded> minute = crowded_minute(laser);
  double worst = 0.0;
  double clusters = 0.0;
  double people = 0.0;
  double sweeps = 0.0;
  for ([[maybe_unused]] auto _ : state) {
    Detector detector({});
    Tracker tracker({});
    for (const Recorded& r : minute) {
      const double before = thread_milliseconds();
      const std::vector<Vector2> keep = tracker.keep_out();
      const LaserSweep sweep{r.time,          r.X_OL,          r.scan.angle_min, r.scan.angle_increment,
                             laser.range_min, laser.range_max, r.scan.ranges};
      const DetectionSet& set = detector.detect(sweep, {nullptr, std::nullopt, keep});
      tracker.update(set);
      worst = std::max(worst, thread_milliseconds() - before);
      clusters = std::max(clusters, static_cast<double>(set.detections.size()));
      people += static_cast<double>(tracker.people().size());
      sweeps += 1.0;
    }
  }
  state.counters["worst_ms"] = worst;
  state.counters["most_clusters"] = clusters;
  state.counters["people"] = people / sweeps;
  state.counters["mean_ms"] =
      benchmark::Counter(sweeps / 1e3, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(Sweep20People200Clusters)->Unit(benchmark::kMillisecond);

/// Everything competes with everything: the worst there is.
void AssignmentAllAgainstAll(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  Random random(3);
  std::vector<double> costs(n * n);
  for (double& cost : costs) cost = random.uniform(0.0, 9.0);
  Assignment assignment;
  for ([[maybe_unused]] auto _ : state) {
    assignment.begin(n);
    for (std::size_t i = 0; i < n; ++i) {
      assignment.add_row(9.21);
      for (std::size_t j = 0; j < n; ++j) assignment.allow(j, costs[i * n + j]);
    }
    benchmark::DoNotOptimize(assignment.solve().data());
  }
}
BENCHMARK(AssignmentAllAgainstAll)->Arg(20)->Arg(200)->Unit(benchmark::kMicrosecond);

/// Twenty who walk, 10 times a second: constant velocity (0) and the learned head (1).
void Predict20People(benchmark::State& state) {
  std::optional<HeadWeights> head;
  if (state.range(0) == 1) head = read_head(BANDWAGON_SOURCE_DIR "/config/people/learned_head.txt");
  Predictor predictor({}, head);
  std::vector<TrackedPerson> people(20);
  double t = 10.0;
  for ([[maybe_unused]] auto _ : state) {
    t += 0.1;
    const Time now = Time::seconds(t);
    for (std::size_t i = 0; i < people.size(); ++i) {
      people[i].id = static_cast<std::uint32_t>(i + 1);
      people[i].velocity = direction(0.314 * static_cast<double>(i));
      people[i].position = t * people[i].velocity;
      people[i].covariance.diagonal() << 1e-4, 1e-4, 0.01, 0.01;
      people[i].last_seen = now;
    }
    predictor.predict(people, {}, now);
    benchmark::DoNotOptimize(people.back().predictions.data());
  }
}
BENCHMARK(Predict20People)->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace bw::people

BENCHMARK_MAIN();
