// From a commanded to a driven wheel speed: the command acts late, the loop follows as a first-order lag, and
// no faster than the motors accelerate.
//
//   v += clamp((v_commanded - v) (1 - exp(-dt / lag)), -acceleration dt, acceleration dt)
#pragma once

#include <deque>

#include "components/model/differential_drive.hpp"
#include "runtime/base/time.hpp"

namespace bw::emulators {

struct WheelControllerOptions {
  /// [s] from the last byte of a command to its effect (set by code alone)
  double latency = 0.02;
  /// [s] time constant of the wheels' control; 0: none (set by code alone)
  double lag = 0.04;
  /// [m/s^2] most that the motors give (set by code alone)
  double acceleration = 3.0;
};

class WheelController {
 public:
  explicit WheelController(const WheelControllerOptions& options) : options_(options) {}

  void command(Time now, const WheelSpeeds& wheels) { waiting_.push_back({now, wheels}); }
  /// Gives up what was commanded, without its latency: the board's own decision.
  void release() {
    waiting_.clear();
    target_ = {};
  }
  void step(Time now, double dt);
  /// What acts now [m/s].
  const WheelSpeeds& target() const { return target_; }
  const WheelSpeeds& speeds() const { return speeds_; }

 private:
  struct Command {
    Time at;
    WheelSpeeds wheels;
  };

  double followed(double speed, double target, double dt) const;

  WheelControllerOptions options_;
  std::deque<Command> waiting_;
  WheelSpeeds target_;
  WheelSpeeds speeds_;
};

}  // namespace bw::emulators
