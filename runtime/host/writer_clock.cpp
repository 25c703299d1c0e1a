#include "runtime/host/writer_clock.hpp"

#include <ctime>

#include "runtime/host/statistics.hpp"

namespace bw {

std::optional<Duration> WriterClock::look(Duration offset) {
  constexpr Duration kReading = Duration::milliseconds(5);  // between the two readings
  const Duration change = offset - offset_;
  if (reach_ == Reach::one_clock || was_set_) return std::nullopt;
  if (change <= kReading && change >= kReading * -1) return std::nullopt;
  was_set_ = true;
  return change;
}

Duration system_clock_offset() {
  // The quickest of three: this thread may be interrupted between two readings.
  Duration least_gap = Duration::seconds(1e6), offset;
  for (int i = 0; i < 3; ++i) {
    const Duration before = steady_time();
    timespec t{};
    clock_gettime(CLOCK_REALTIME, &t);
    const Duration gap = steady_time() - before;
    if (gap >= least_gap) continue;
    least_gap = gap;
    offset = Duration{static_cast<std::int64_t>(t.tv_sec) * 1'000'000'000 + t.tv_nsec} - before;
  }
  return offset;
}

}  // namespace bw
