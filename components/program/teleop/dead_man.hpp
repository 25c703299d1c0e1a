// A hand on keys as a velocity. A terminal tells that a key went down and, while it is held, again and again;
// it never tells that it was let go. So each of these lets the robot drive a little further, and silence is
// the stop: a dead-man's handle.
//
// Most keyboards begin to repeat after 250 to 660 ms and then come every 25 to 40 ms. A key that is held
// drives at once, stands until the keyboard begins to repeat it, and then goes on; a key that is tapped moves
// the robot by `hold` times its speed. A hold as long as that first delay would let the robot drive on for as
// long after the hand has left.
#pragma once

#include <optional>

#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw {

struct DeadManOptions {
  double v = 0.3;      ///< forward, at 100 % [m/s]
  double omega = 0.8;  ///< rotating, at 100 % [rad/s]
  Duration hold = Duration::milliseconds(200);
};

/// Where a key drives: each 1, 0 or -1, forward and to the left.
struct Direction {
  int forward = 0;
  int rotation = 0;
};

class DeadMan {
 public:
  explicit DeadMan(const DeadManOptions& options) : options_(options) {}

  void press(Time now, const Direction& direction) {
    direction_ = direction;
    until_ = now + options_.hold;
  }
  void let_go() { until_.reset(); }
  /// Slower or faster by a tenth, 10 to 100 %.
  void change_speed(int tenths);
  double share() const { return tenths_ / 10.0; }

  bool is_driving(Time now) const { return until_ && now < *until_; }
  /// When the handle is let go, as far as is known now.
  std::optional<Time> until() const { return until_; }
  Twist2 twist(Time now) const;

 private:
  DeadManOptions options_;
  Direction direction_;
  std::optional<Time> until_;
  int tenths_ = 5;
};

}  // namespace bw
