#include "runtime/host/component_clock.hpp"

#include "runtime/host/statistics.hpp"
#include "runtime/host/writer_clock.hpp"

namespace bw {

MonotonicClock::MonotonicClock() : offset_(system_clock_offset()) {}

Time MonotonicClock::now() const { return {(steady_time() + offset_).nanoseconds}; }

void TopicClock::set(Time now) {
  now_ns_ = now.nanoseconds;
  if (wake_) wake_();
}

}  // namespace bw
