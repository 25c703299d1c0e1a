// How fast a base is let go backwards, seen from what became of commands: a collision monitor lets a robot
// only creep to where no laser looks, and a planner that expects more stands in the way.
#pragma once

#include <cmath>
#include <optional>

namespace bw {

class BackwardSpeed {
 public:
  /// Once a control cycle: the speed of the last command and the one measured now [m/s]. Returns the fastest
  /// to plan with [m/s, not negative], at most `v_back_max`: what it went at, where for three cycles it was
  /// told to go faster backwards and went on as before. Who does not go back at all, as with something close
  /// behind, learns nothing. Forgotten after 100 cycles, and when it goes faster.
  double update(double commanded, double measured, double v_back_max) {
    const bool is_held =
        measured < -kGoes && commanded < measured - kSame && std::abs(measured - last_measured_) < kSame;
    held_ = is_held ? held_ + 1 : 0;
    last_measured_ = measured;
    if (held_ >= kHeldFor) {
      known_ = -measured;
      age_ = 0;
    } else if (known_ && (measured < -*known_ - kSame || ++age_ > kRemembered)) {
      known_.reset();
    }
    return known_ ? std::fmin(*known_, v_back_max) : v_back_max;
  }

 private:
  static constexpr double kGoes = 0.05;  // [m/s]
  static constexpr double kSame = 0.02;  // [m/s]
  static constexpr int kHeldFor = 3;     // cycles
  static constexpr int kRemembered = 100;

  std::optional<double> known_;  // [m/s]
  double last_measured_ = 0.0;
  int held_ = 0;
  int age_ = 0;
};

}  // namespace bw
