#include "runtime/host/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <utility>

#include "runtime/base/quantile.hpp"

namespace bw {
namespace {

constexpr double kFirstBucketNs = 100.0;
const double kLogGrowth = std::log(1.02);
constexpr std::size_t kBuckets = 1200;  // up to 100 ns * 1.02^1200 = 2000 s

Duration read_clock(clockid_t id) {
  timespec t{};
  clock_gettime(id, &t);
  return {static_cast<std::int64_t>(t.tv_sec) * 1'000'000'000 + t.tv_nsec};
}

}  // namespace

void DurationHistogram::add(Duration d) {
  if (buckets_.empty()) buckets_.resize(kBuckets);
  const double ratio = static_cast<double>(std::max<std::int64_t>(d.nanoseconds, 1)) / kFirstBucketNs;
  const double bucket = ratio <= 1.0 ? 0.0 : std::log(ratio) / kLogGrowth;
  ++buckets_[std::min(static_cast<std::size_t>(bucket), kBuckets - 1)];
  ++count_;
  sum_ns_ += d.nanoseconds;
  max_ = std::max(max_, d);
}

double DurationHistogram::mean_ms() const {
  return count_ == 0 ? 0.0 : static_cast<double>(sum_ns_) * 1e-6 / static_cast<double>(count_);
}

double DurationHistogram::quantile_ms(double q) const {
  if (count_ == 0) return 0.0;
  const std::uint64_t wanted = nearest_rank(count_, q);
  std::uint64_t seen = 0;
  for (std::size_t i = 0; i < kBuckets; ++i) {
    seen += buckets_[i];
    if (seen > wanted) {
      const double middle_ns = kFirstBucketNs * std::exp((static_cast<double>(i) + 0.5) * kLogGrowth);
      return std::min(middle_ns, static_cast<double>(max_.nanoseconds)) * 1e-6;
    }
  }
  return static_cast<double>(max_.nanoseconds) * 1e-6;
}

Duration thread_cpu_time() { return read_clock(CLOCK_THREAD_CPUTIME_ID); }

Duration thread_cpu_lap() {
  // Within so short a time the thread was hardly put aside, and the steady clock costs no system call.
  constexpr Duration kShort{20'000};
  thread_local Duration last_steady, last_cpu, told_since;
  const Duration now = steady_time();
  const Duration passed = now - std::exchange(last_steady, now);
  if (passed < kShort) {
    told_since = told_since + passed;
    return passed;
  }
  const Duration cpu = thread_cpu_time();
  const Duration spent = cpu - std::exchange(last_cpu, cpu) - std::exchange(told_since, {});
  return std::max(spent, Duration{});
}

Duration steady_time() { return read_clock(CLOCK_MONOTONIC); }

}  // namespace bw
