// What kind of Kobuki is emulated. What no document tells is a design choice, and said to be one in the
// README.
#pragma once

#include <cstdint>

#include "components/emulators/battery.hpp"
#include "components/emulators/wheel_controller.hpp"

namespace bw::emulators {

struct KobukiGyroOptions {
  /// [deg/s] of the raw samples, about each axis (set by code alone)
  double bias = 0.4;
  /// [deg/s] standard deviation of a raw sample (set by code alone)
  double noise = 0.1;
  /// 0.01: turns are told 1 % too large (set by code alone)
  double scale_error = 0.0;
  /// [deg/s] what its own calibration leaves in angle and rate (set by code alone)
  double drift = 0.01;
  /// [deg] that it tells at the start (set by code alone)
  double first_angle = 37.25;
  /// [Hz] raw samples; 2 or 3 come in a packet at 104 (set by code alone)
  double sample_rate = 104.0;
};

struct KobukiOptions {
  /// [s] without a base command for so long it stops; 0: never, as is to be assumed (set by code alone)
  double stops_by_itself = 0.0;
  /// [ms] of its clock at the start; near 65536 to see it wrap (set by code alone)
  std::int64_t first_stamp = 0;
  /// of both encoders at the start; near 65536 to see them wrap (set by code alone)
  std::int64_t first_ticks = 0;
  /// [m] that it computes with, whatever the robot has (set by code alone)
  double wheelbase = 0.230;
  /// [m] likewise (set by code alone)
  double wheel_radius = 0.035;
  /// from a base command to rotating wheels (set by code alone)
  WheelControllerOptions wheels;
  KobukiGyroOptions gyro;
  BatteryOptions battery;
};

}  // namespace bw::emulators
