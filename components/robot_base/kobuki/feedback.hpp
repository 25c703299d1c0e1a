// What a packet of a Kobuki says: its sub-payloads, as the board counts and scales them. All numbers are
// little endian.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace bw::kobuki {

/// 01. Bits: 1 right, 2 centre, 4 left for bumper and cliff, 1 right, 2 left for the wheel drop, 1 left, 2
///     right for the overcurrent.
struct Core {
  std::uint16_t stamp = 0;  ///< [ms], wraps
  std::uint8_t bumper = 0, wheel_drop = 0, cliff = 0;
  std::uint16_t left_encoder = 0, right_encoder = 0;  ///< forward +, wrap
  std::int8_t left_pwm = 0, right_pwm = 0;
  std::uint8_t buttons = 0;
  std::uint8_t charger =
      0;  ///< 0 not charging; docked: 2 full, 6 charging; at the adapter: 18 full, 22 charging
  std::uint8_t battery = 0;  ///< [0.1 V]
  std::uint8_t overcurrent = 0;
};

/// 04.
struct Inertia {
  std::int16_t angle = 0;  ///< [0.01 degrees], from an unknown zero
  std::int16_t rate = 0;   ///< [0.01 degrees/s]
};

/// 03, 05, 06, 10: right, centre, left; left, right.
struct DockInfrared {
  std::uint8_t right = 0, centre = 0, left = 0;
};
struct CliffSensors {
  std::uint16_t right = 0, centre = 0, left = 0;  ///< 4096 is 3.3 V
};
struct Currents {
  std::uint8_t left = 0, right = 0;  ///< [10 mA]
};
struct Inputs {
  std::uint16_t digital = 0;
  std::array<std::uint16_t, 4> analog{};
};

/// 0D. The chip is rotated: x of the robot is -y, y is x, z is z. [0.00875 degrees/s]
struct RawGyro {
  std::uint8_t frame = 0;  ///< counts samples
  std::vector<std::array<std::int16_t, 3>> samples;
};

/// 0A, 0B.
struct Version {
  std::uint8_t patch = 0, minor = 0, major = 0;
};

/// 15. Times 1000.
struct ControllerInfo {
  bool is_user = false;
  std::uint32_t p = 0, i = 0, d = 0;
};

struct Feedback {
  std::optional<Core> core;
  std::optional<DockInfrared> dock;
  std::optional<Inertia> inertia;
  std::optional<CliffSensors> cliff;
  std::optional<Currents> currents;
  std::optional<RawGyro> gyro;
  std::optional<Inputs> inputs;
  std::optional<Version> hardware, firmware;
  std::optional<std::array<std::uint32_t, 3>> id;
  std::optional<ControllerInfo> controller;
  int skipped = 0;  ///< sub-payloads that are not known, or known with another size
};

/// Of a payload whose sub-payloads fill it (PacketReader); what is left over behind the last whole one is
/// ignored.
Feedback parse(std::span<const std::uint8_t> payload);

}  // namespace bw::kobuki
