// Are stamps on the time base of the component's clock, and when have both jumped?
//
// Wheel steps carry the time base: they are many, local and quick. One stamp far off is a fault of that
// message; steps that are refused for a second by a clock that keeps to itself (runtime/base/stamp_age.hpp)
// are of a clock that was set.
#pragma once

#include "components/localization/measurements.hpp"
#include "runtime/base/stamp_age.hpp"

namespace bw::localization {

class StampWatch {
 public:
  explicit StampWatch(Duration future_tolerance) : tolerance_(future_tolerance) {}

  /// True when now went back by more than the tolerance: simulated time began again, or a record did.
  bool clock_went_back(Time now) {
    const bool back = seen_ && now + tolerance_ < last_now_;
    seen_ = true;
    last_now_ = now;
    return back;
  }

  bool in_future(Time stamp, Time now) const { return stamp > now + shift_ + tolerance_; }

  /// Each wheel step; `is_refused`: for its stamp. True when the clock behind the stamps was set: their new
  /// base counts from then on.
  bool was_set(const WheelStep& step, bool is_refused, Time now) {
    const StampAge age = clock_.add(now, step.time);
    lost_ = is_refused ? lost_ + step.over : Duration{};
    if (!is_refused || age.fault != StampFault::none) return false;
    shift_ = step.time - now;
    return true;
  }

  void forget_shift() { shift_ = Duration{}; }
  /// Time that the refused steps before the last jump spanned: motion that was missed.
  Duration lost() const { return lost_; }
  /// `now` on the time base of the stamps.
  Time on_stamps(Time now) const { return now + shift_; }

 private:
  Duration tolerance_;
  ForeignClock clock_{ForeignClock::Delivery::direct};
  Duration shift_;
  Duration lost_;
  Time last_now_;
  bool seen_ = false;
};

}  // namespace bw::localization
