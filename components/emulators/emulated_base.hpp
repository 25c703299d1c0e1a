// The firmware of a base and its board, emulated byte by byte from its protocol; it shares no code with our
// drivers. The world behind it is the simulated one: who hosts it gives it the true wheels and body, and
// rotates the wheels as its motors say. Values in, result out: no clock, no file, no middleware.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "components/model/differential_drive.hpp"
#include "components/robot_base/readings.hpp"
#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw::emulators {

enum class Charger : std::uint8_t { none, dock, adapter };

/// A beam of a ranging sensor, along x of `X_base_sensor`, and how wide it is [rad].
struct Beam {
  Pose2 X_base_sensor;
  double half_angle = 0.0;
  double reach = 0.0;  ///< beyond it nothing is seen [m]
};

/// The truth at an instant.
struct Body {
  std::int32_t left_ticks = 0,
               right_ticks =
                   0;  ///< counted by the wheels' encoders since the start, with slip and noise; they wrap
  Twist2 twist;        ///< of base_link
  ContactReading contacts;  ///< what touches it, what is below it
  Charger charger = Charger::none;
  double battery_voltage = std::numeric_limits<double>::quiet_NaN();  ///< forced upon it [V]; NaN: its own
  std::uint32_t buttons = 0;                                          ///< pressed, as bits
  Duration clock_offset;                                              ///< by how much its clock has jumped
  std::vector<double> ranges;  ///< of its beams, in their order [m]; infinite: nothing in reach
};

class EmulatedBase {
 public:
  virtual ~EmulatedBase() = default;
  /// Bytes off the cable; returns what is answered at once, valid until the next call.
  virtual std::span<const std::uint8_t> receive(Time now, std::span<const std::uint8_t> bytes) = 0;
  /// Up to `now`, in steps of at most 10 ms: what it sends; valid until the next call. Also when no cable is
  /// plugged in: it goes on.
  virtual std::span<const std::uint8_t> step(Time now, const Body& body) = 0;
  /// What its controller makes the wheels rotate at: speeds of their rims [m/s], were they of `wheel_radius`.
  virtual WheelSpeeds motors() const = 0;
  /// Of the wheels that it computes with, whatever the robot has [m].
  virtual double wheel_radius() const = 0;
  /// Of its ranging sensors; empty: it has none.
  virtual std::vector<Beam> beams() const { return {}; }
};

}  // namespace bw::emulators
