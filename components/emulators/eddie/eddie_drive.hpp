// Motion of an Eddie board, in positions of its encoders: power, speed ramped with ACC, or a distance to go.
#pragma once

#include <deque>

#include "runtime/base/time.hpp"

namespace bw::emulators {

struct WheelPair {
  double left = 0.0, right = 0.0;
};

struct EddieMotion {
  enum class Kind {
    power,  ///< wheels [positions/s] as the voltage makes them, without a loop
    speed,  ///< wheels [positions/s]
    stop,   ///< over `distance` positions; 0: at once
    travel  ///< wheels [positions] from here, at most at `distance` positions/s
  };
  Kind kind = Kind::speed;
  WheelPair wheels;
  double distance = 0.0;
};

class EddieDrive {
 public:
  /// `latency` from a command to its effect; `acceleration` [positions/s^2] until another one is set.
  EddieDrive(Duration latency, double acceleration) : latency_(latency), acceleration_(acceleration) {}

  void move(Time now, const EddieMotion& motion) { waiting_.push_back({now, motion}); }
  void set_acceleration(double acceleration) { acceleration_ = acceleration; }
  /// Off, whatever was commanded.
  void switch_off();
  /// `positions`: where the wheels are, since the start.
  void step(Time now, double dt, const WheelPair& positions);
  /// [positions/s]
  const WheelPair& speeds() const { return speeds_; }

 private:
  struct Command {
    Time at;
    EddieMotion motion;
  };

  void begin(const EddieMotion& motion, const WheelPair& positions);
  double travelling(double speed, double goal, double position, double dt) const;

  Duration latency_;
  double acceleration_;
  std::deque<Command> waiting_;
  EddieMotion motion_;
  WheelPair goal_;             ///< of a distance to go [positions]
  double deceleration_ = 0.0;  ///< of a stop [positions/s^2]
  WheelPair speeds_;
};

}  // namespace bw::emulators
