// Wheels of a Kobuki: from speed and radius of a base command to two wheel speeds, the loop that follows
// them, and the current that it takes.
#pragma once

#include <optional>

#include "components/emulators/kobuki/kobuki_options.hpp"

namespace bw::emulators {

/// Wheel speeds [m/s] of a base command: `speed` [mm/s] is that of the outer wheel; radius [mm] 0 is straight
/// on, 1 in place.
WheelSpeeds decode_base_control(int speed, int radius, double wheelbase);

/// Motor current [A]: friction by speed, and what a wheel lacks of the speed it should have.
double motor_current(double wanted, double actual);

struct MotorState {
  double current = 0.0;  ///< [A]
  bool is_over = false;  ///< more than 3 A: the board has switched the motor off, until it is told to stand
};

class KobukiMotors {
 public:
  explicit KobukiMotors(const KobukiOptions& options) : options_(options), controller_(options.wheels) {}

  void base_control(Time now, int speed, int radius);
  /// `actual`: how fast the wheels really rotate [m/s].
  void step(Time now, double dt, const WheelSpeeds& actual);
  WheelSpeeds speeds() const;
  const MotorState& left() const { return left_; }
  const MotorState& right() const { return right_; }

 private:
  KobukiOptions options_;
  WheelController controller_;
  std::optional<Time> commanded_;
  MotorState left_, right_;
};

}  // namespace bw::emulators
