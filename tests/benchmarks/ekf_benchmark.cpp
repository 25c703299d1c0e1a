// CPU time of the EKF on a drive of simulated_drive.hpp (encoders and gyro 100 Hz, compass 10 Hz, receiver
// 5 Hz): asked for are 1 us a measurement, 10 us for 999 of 1000, 100 us for a fix half a second late.
#include <algorithm>
#include <ctime>
#include <vector>

#include <benchmark/benchmark.h>

#include "components/localization/ekf/ekf.hpp"
#include "runtime/base/quantile.hpp"
#include "tests/components/localization/simulated_drive.hpp"

namespace bw::localization {
namespace {

double thread_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

const Drive& drive() {
  static const Drive instance = [] {
    DriveOptions options;
    options.seconds = 300.0;
    return simulate(options);
  }();
  return instance;
}

EkfOptions options(const benchmark::State& state) {
  EkfOptions result;
  result.adaptive.enabled = state.range(0) != 0;
  return result;
}

void start(Ekf& ekf) { ekf.start_at({}, 0.01 * Eigen::Matrix3d::Identity(), kStart); }

// One iteration is the whole drive: 69,000 measurements; divide by `measurements`.
void InOrder(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) {
    Ekf ekf(options(state));
    start(ekf);
    for (const Measurement& m : drive().measurements) ekf.add(m, stamp(m));
    benchmark::DoNotOptimize(ekf.estimate());
  }
  const auto count = static_cast<double>(drive().measurements.size());
  state.counters["per_measurement"] =
      benchmark::Counter(count, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(InOrder)->ArgName("adaptive")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

// Each measurement timed by itself, the least of five drives: what the machine does meanwhile is not the
// filter's. The clock's own 0.2 us or so is included.
void InOrderOneByOne(benchmark::State& state) {
  std::vector<double> times(drive().measurements.size(), 1.0);
  for ([[maybe_unused]] auto _ : state) {
    Ekf ekf(options(state));
    start(ekf);
    for (std::size_t i = 0; i < times.size(); ++i) {
      const Measurement& m = drive().measurements[i];
      const double before = thread_seconds();
      ekf.add(m, stamp(m));
      times[i] = std::min(times[i], thread_seconds() - before);
    }
  }
  state.counters["median"] = quantile(times, 0.5);
  state.counters["p99.9"] = quantile(times, 0.999);
  state.counters["worst"] = quantile(times, 1.0);
}
BENCHMARK(InOrderOneByOne)->ArgName("adaptive")->Arg(0)->Unit(benchmark::kMillisecond)->Iterations(5);

// The time of fixes that come half a second late, without that of all others.
void FixHalfASecondLate(benchmark::State& state) {
  double replayed = 0.0;
  double fixes = 0.0;
  for ([[maybe_unused]] auto _ : state) {
    Ekf ekf(options(state));
    start(ekf);
    std::vector<Measurement> waiting;
    std::size_t next = 0;
    double time = 0.0;
    for (const Measurement& m : drive().measurements) {
      if (std::holds_alternative<PositionFix>(m)) {
        waiting.push_back(m);
        continue;
      }
      ekf.add(m, stamp(m));
      if (next == waiting.size() || stamp(m) < stamp(waiting[next]) + Duration::milliseconds(500)) continue;
      const double before = thread_seconds();
      const Outcome outcome = ekf.add(waiting[next++], stamp(m));
      time += thread_seconds() - before;
      replayed += outcome.replayed;
      fixes += 1.0;
    }
    state.SetIterationTime(time / static_cast<double>(next));
  }
  state.counters["replayed"] = replayed / fixes;
}
BENCHMARK(FixHalfASecondLate)
    ->ArgName("adaptive")
    ->Arg(0)
    ->Unit(benchmark::kMicrosecond)
    ->UseManualTime()
    ->Iterations(10);

}  // namespace
}  // namespace bw::localization

BENCHMARK_MAIN();
