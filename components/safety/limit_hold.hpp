// A speed limit that falls at once and rises late and gently, so that the robot does not stop and go with
// every sweep.
#pragma once

#include <algorithm>

#include "runtime/base/time.hpp"

namespace bw::safety {

class LimitHold {
 public:
  /// After `clear_after` without a tighter limit the held one rises with `acceleration` [m/s^2].
  LimitHold(Duration clear_after, double acceleration)
      : clear_after_(clear_after), acceleration_(acceleration) {}

  /// The limit to obey at `now`, for the limit [m/s] that holds now in the direction of travel (+1, -1). A
  /// new direction starts afresh.
  double update(Time now, double limit, int direction) {
    const double dt = std::max(0.0, (now - updated_at_).to_seconds());
    updated_at_ = now;
    if (tight_at_ > now) tight_at_ = now;  // the clock went back
    if (direction != direction_ || limit <= held_) {
      held_ = limit;
      direction_ = direction;
      tight_at_ = now;
    } else if (now - tight_at_ >= clear_after_) {
      held_ = std::min(limit, held_ + acceleration_ * dt);
    }
    return held_;
  }

 private:
  Duration clear_after_;
  double acceleration_;
  Time updated_at_;
  Time tight_at_;
  double held_ = 0.0;
  int direction_ = 0;  ///< 0: nothing held yet
};

}  // namespace bw::safety
