#include "components/emulators/faults.hpp"

namespace bw::emulators {

Body seen_with(Body body, const Faults& faults) {
  const auto jumped = [&](std::int32_t ticks) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(ticks) +
                                     static_cast<std::uint32_t>(faults.tick_jump));
  };
  body.left_ticks = jumped(body.left_ticks);
  body.right_ticks = jumped(body.right_ticks);
  ContactReading& contacts = body.contacts;
  contacts.bumper_left |= faults.bumper_left;
  contacts.bumper_centre |= faults.bumper_centre;
  contacts.bumper_right |= faults.bumper_right;
  contacts.cliff_left |= faults.cliff_left;
  contacts.cliff_centre |= faults.cliff_centre;
  contacts.cliff_right |= faults.cliff_right;
  contacts.drop_left |= faults.drop_left;
  contacts.drop_right |= faults.drop_right;
  if (faults.battery_voltage > 0.0) body.battery_voltage = faults.battery_voltage;
  body.charger = faults.charger;
  body.buttons |= static_cast<std::uint32_t>(faults.buttons);
  body.clock_offset = Duration::seconds(faults.clock_jump);
  return body;
}

WheelSpeeds with_faults(WheelSpeeds motors, const Faults& faults) {
  if (faults.runaway_left != 0.0) motors.left = faults.runaway_left;
  if (faults.runaway_right != 0.0) motors.right = faults.runaway_right;
  if (faults.stalled_left) motors.left = 0.0;
  if (faults.stalled_right) motors.right = 0.0;
  return motors;
}

}  // namespace bw::emulators
