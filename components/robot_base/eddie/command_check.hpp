// Does the board do what GOSPD says? The documents contradict each other about its unit, a motor or an
// encoder may be plugged in the wrong way round, and a board may drive on by itself. So the counts of DIST
// are compared with the speeds that were commanded.
//
// Over a window of 0.2 s each wheel's speed must lie within 1.5 times the commands that may still show in it,
// and a tolerance:
//
//   1.5 min(0, c) - tolerance <= measured <= 1.5 max(0, c) + tolerance,   tolerance = 0.05 m/s + 2 counts / 0.2 s
//
// A command c shows for 0.3 s after the next one, c2, and as long as the board's ramp takes from it: (|c| +
// |c2|) / ACC. Three readings in a row that do not fit are a contradiction. Standing where it should turn is
// left to robot_base; turning at half of a steady command is the other way to be wrong about the unit.
#pragma once

#include <deque>
#include <string>

#include "components/model/differential_drive.hpp"
#include "runtime/base/time.hpp"

namespace bw::eddie {

class CommandCheck {
 public:
  /// `metres_per_count` of the coarser wheel; `acceleration` [m/s^2] of the board's ramp.
  CommandCheck(double metres_per_count, double acceleration)
      : metres_per_count_(metres_per_count), acceleration_(acceleration) {}

  void reset();
  /// Ground speeds [m/s] that the board was told.
  void told(Time now, const WheelSpeeds& wheels);
  /// Travel of the wheels [m] since any moment; says what contradicts the commands, empty: nothing.
  std::string measured(Time now, const WheelSpeeds& travel);

 private:
  struct Sample {
    Time time;
    WheelSpeeds value;
  };
  struct Span {
    double low = 0.0, high = 0.0;
  };
  Span commanded(Time now, double WheelSpeeds::*wheel) const;
  std::string too_fast(Time now);
  std::string too_slow(Time now);

  double metres_per_count_, acceleration_;
  std::deque<Sample> commands_, travels_;
  int fast_in_a_row_ = 0, slow_in_a_row_ = 0;
};

}  // namespace bw::eddie
