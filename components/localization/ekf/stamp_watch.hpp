// Are stamps on the time base of the component's clock, and when have both jumped?
//
// Wheel steps carry the time base: they are many, local and quick. One stamp far off is a fault of that
// message. kConfirmations in a row that are off by the same amount are a clock that jumped.
#pragma once

#include "components/localization/measurements.hpp"

namespace bw::localization {

class StampWatch {
 public:
  explicit StampWatch(Duration future_tolerance) : tolerance_(future_tolerance) {}

  static constexpr int kConfirmations = 20;
  static constexpr Duration kSteady = Duration::milliseconds(100);

  /// True when now went back by more than the tolerance: simulated time began again, or a record did.
  bool clock_went_back(Time now) {
    const bool back = seen_ && now + tolerance_ < last_now_;
    seen_ = true;
    last_now_ = now;
    return back;
  }

  bool in_future(Time stamp, Time now) const { return stamp > now + shift_ + tolerance_; }

  /// A wheel step that was refused for its stamp. True when the clock behind the stamps has jumped: the
  /// stamps' new base counts from then on.
  bool jumped(const WheelStep& step, Time now) {
    const Duration offset = step.time - now;
    const Duration change = offset - offset_;
    const bool steady = count_ > 0 && change <= kSteady && change >= kSteady * -1;
    if (!steady) {
      count_ = 0;
      lost_ = Duration{};
    }
    offset_ = offset;
    ++count_;
    lost_ = lost_ + step.over;
    if (count_ < kConfirmations) return false;
    count_ = 0;
    shift_ = offset;
    return true;
  }

  void wheel_accepted() { count_ = 0; }
  void forget_shift() { shift_ = Duration{}; }
  /// Time that the refused steps before the last jump spanned: motion that was missed.
  Duration lost() const { return lost_; }
  /// `now` on the time base of the stamps.
  Time on_stamps(Time now) const { return now + shift_; }

 private:
  Duration tolerance_;
  Duration shift_;
  Duration offset_;
  Duration lost_;
  int count_ = 0;
  Time last_now_;
  bool seen_ = false;
};

}  // namespace bw::localization
