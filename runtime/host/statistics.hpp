// Distribution of durations in constant memory: counts in buckets that grow by 2 %, so that a quantile is
// right within 2 %.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/base/time.hpp"

namespace bw {

class DurationHistogram {
 public:
  void add(Duration d);
  std::uint64_t count() const { return count_; }
  Duration max() const { return max_; }
  double mean_ms() const;
  /// The duration that a share `q` in [0, 1] stays below [ms]; 0 without samples.
  double quantile_ms(double q) const;

 private:
  std::vector<std::uint32_t> buckets_;
  std::uint64_t count_ = 0;
  Duration max_;
  std::int64_t sum_ns_ = 0;
};

/// One callback of one component.
struct CallbackStatistics {
  std::string component;
  std::string callback;        ///< timer name or input topic
  DurationHistogram run;       ///< thread CPU time
  DurationHistogram wait;      ///< from the event to the start of the callback; empty in lock-step
  std::uint64_t rejected = 0;  ///< samples that did not hold the message
  std::uint64_t missed = 0;    ///< timer ticks that were coalesced
};

/// CPU time spent by the calling thread.
Duration thread_cpu_time();
/// The same since this was last asked on the thread: of a callback with what led to it. What took less than 20 us is told
/// by the steady clock, since the CPU clock is a system call that costs as much as a small callback.
Duration thread_cpu_lap();
/// Monotonic time since an arbitrary start.
Duration steady_time();

}  // namespace bw
