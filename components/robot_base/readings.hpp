// What a base told since it was last asked. Each part is there only if the base has it and told it. Times are
// of the component clock: when it was measured, as well as the driver knows.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "components/robot_base/encoder_odometry.hpp"
#include "runtime/base/byte_link.hpp"
#include "runtime/base/time.hpp"

namespace bw {

struct GyroReading {
  Time time;
  double rate = 0.0;  ///< about z, counter-clockwise [rad/s]
  double angle =
      std::numeric_limits<double>::quiet_NaN();  ///< since the first reading, unwrapped [rad]; NaN: not told
};

/// Pressed bumpers, seen cliffs, dropped wheels. The middle one counts for both sides.
struct ContactReading {
  bool bumper_left = false, bumper_centre = false, bumper_right = false;
  bool cliff_left = false, cliff_centre = false, cliff_right = false;
  bool drop_left = false, drop_right = false;
  bool any_bumper() const { return bumper_left || bumper_centre || bumper_right; }
  bool any_cliff() const { return cliff_left || cliff_centre || cliff_right; }
  bool any_drop() const { return drop_left || drop_right; }
  bool operator==(const ContactReading&) const = default;
};

struct BatteryReading {
  double voltage = 0.0;                                      ///< [V]
  double charge = std::numeric_limits<double>::quiet_NaN();  ///< share of the full one, 0 to 1; NaN: not told
  bool is_charging = false;
  bool is_plugged = false;  ///< charger connected, charging or full
};

/// Motors, left and right [A].
struct CurrentReading {
  double left = 0.0, right = 0.0;
  bool is_over_left = false, is_over_right = false;  ///< above what the board allows
};

/// A beam of a sonar or an infrared ranger.
struct RangeReading {
  Time time;
  std::size_t ranger = 0;  ///< index into Driver::rangers()
  double range = 0.0;      ///< [m]; +inf: nothing in reach
};

struct Readings {
  std::vector<EncoderCounts> counts;  ///< in the order of their stamps
  std::vector<GyroReading> gyro;
  std::optional<ContactReading> contacts;
  std::optional<BatteryReading> battery;
  std::optional<CurrentReading> currents;
  std::optional<std::uint32_t> buttons;  ///< bits, the first button's is the lowest
  std::vector<RangeReading> ranges;
  LinkState link{.is_open = true};  ///< of the cable; a driver without one leaves it so
  std::string fault;    ///< what the base or its answers have wrong, for people; empty: all is well
  std::string warning;  ///< what people should know although it drives; empty: nothing
};

}  // namespace bw
