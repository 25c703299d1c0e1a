// The board's stamps on the component clock. A packet arrives some time after it was stamped: at least the
// time on the line, and up to whatever the host was busy with. So what is added to the board's clock is the
// least of arrival minus stamp, which follows its drift (runtime/base/stamp_age.hpp). Stamps are 16 bits of
// milliseconds; how often they wrapped in a silence is what fits the arrivals best.
//
// A stamp that goes back, an arrival sooner than any before by more than 20 ms, or later by more than 50 ms
// for a second, is no delay: one of the clocks jumped. That is counted, and the offset is taken anew.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/base/stamp_age.hpp"
#include "runtime/base/time.hpp"

namespace bw::kobuki {

class BoardClock {
 public:
  /// The times of packets that were read together at `arrival`, in their order; they rise, but for a jump,
  /// and are not later than `arrival` by more than what keeps them rising.
  std::vector<Time> times(Time arrival, std::span<const std::uint16_t> stamps);
  std::uint64_t jumps() const { return jumps_; }
  /// What was added to the newest stamp, unwrapped [ns]; for tests.
  std::int64_t offset() const { return clock_.least().nanoseconds; }

 private:
  std::int64_t unwrap(std::uint16_t stamp, Time arrival) const;
  void take(Time arrival, std::int64_t board, bool is_first, bool went_back);

  struct Newest {
    std::uint16_t stamp = 0;
    std::int64_t board = 0;  ///< unwrapped [ns]
    Time arrival;
    Time time;
  };
  std::optional<Newest> newest_;
  ForeignClock clock_{ForeignClock::Delivery::direct};
  bool may_step_ = true;  ///< the next time need not rise evenly
  std::uint64_t jumps_ = 0;
};

}  // namespace bw::kobuki
