#include "runtime/host/component_clock.hpp"

#include <ctime>

#include "runtime/host/statistics.hpp"

namespace bw {

MonotonicClock::MonotonicClock() {
  timespec t{};
  clock_gettime(CLOCK_REALTIME, &t);
  offset_ = Duration{static_cast<std::int64_t>(t.tv_sec) * 1'000'000'000 + t.tv_nsec} - steady_time();
}

Time MonotonicClock::now() const { return {(steady_time() + offset_).nanoseconds}; }

void TopicClock::set(Time now) {
  now_ns_ = now.nanoseconds;
  if (wake_) wake_();
}

}  // namespace bw
