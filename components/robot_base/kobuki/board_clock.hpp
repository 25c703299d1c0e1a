// The board's stamps on the component clock. A packet arrives some time after it was stamped: at least the time on the line, and up
// to whatever the host was busy with. So what is added to the board's clock is the least of arrival minus stamp:
//
//   time = stamp + offset,  offset = min over packets of (arrival - stamp), + drift_max for every second since then
//
// The rise lets it follow a board whose clock is slow; one that is fast lowers it by itself. Stamps are 16 bits of milliseconds; how
// often they wrapped in a silence is what fits the arrivals best.
//
// A stamp that goes back, an arrival sooner than any before by more than 100 ms, later by more than a second, or later by more than
// 50 ms for a second, is no delay: one of the clocks jumped. That is counted, and the offset is taken anew.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/base/time.hpp"

namespace bw::kobuki {

class BoardClock {
 public:
  static constexpr double kDriftMax = 5e-4;

  /// The times of packets that were read together at `arrival`, in their order; they rise, but for a jump, and are not later than
  /// `arrival` by more than what keeps them rising.
  std::vector<Time> times(Time arrival, std::span<const std::uint16_t> stamps);
  std::uint64_t jumps() const { return jumps_; }
  /// What was added to the newest stamp, unwrapped [ns]; for tests.
  std::int64_t offset() const { return offset_; }

 private:
  std::int64_t unwrap(std::uint16_t stamp, Time arrival) const;
  void take(Time arrival, std::int64_t sample, bool went_back);
  void begin(Time arrival, std::int64_t sample);

  struct Newest {
    std::uint16_t stamp = 0;
    std::int64_t board = 0;  ///< unwrapped [ns]
    Time arrival;
    Time time;
  };
  std::optional<Newest> newest_;
  std::optional<Time> taken_;  ///< of the newest arrival that went into the offset
  std::int64_t offset_ = 0;
  bool may_step_ = true;  ///< the next time need not rise evenly
  int window_arrivals_ = 0;
  Time window_start_;  ///< of the second in which the least offset is looked for
  std::int64_t window_least_ = 0;
  std::uint64_t jumps_ = 0;
};

}  // namespace bw::kobuki
