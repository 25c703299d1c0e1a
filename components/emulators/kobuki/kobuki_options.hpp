// What kind of Kobuki is emulated. What no document tells is a design choice, and said to be one in the README.
#pragma once

#include <cstdint>

#include "components/emulators/battery.hpp"
#include "components/emulators/wheel_controller.hpp"
#include "runtime/base/field.hpp"

namespace bw::emulators {

struct KobukiGyroOptions {
  double bias = 0.4;
  double noise = 0.1;
  double scale_error = 0.0;
  double drift = 0.01;
  double first_angle = 37.25;
  double sample_rate = 104.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("bias", bias, {.unit = "deg/s", .min = -20, .max = 20, .doc = "of the raw samples, about each axis"});
    v("noise", noise, {.unit = "deg/s", .min = 0, .max = 20, .doc = "standard deviation of a raw sample"});
    v("scale_error", scale_error, {.min = -0.2, .max = 0.2, .doc = "0.01: turns are told 1 % too large"});
    v("drift", drift,
      {.unit = "deg/s", .min = -5, .max = 5, .doc = "what its own calibration leaves in angle and rate"});
    v("first_angle", first_angle,
      {.unit = "deg", .min = -180, .max = 180, .doc = "that it tells at the start"});
    v("sample_rate", sample_rate,
      {.unit = "Hz", .min = 50, .max = 500, .doc = "raw samples; 2 or 3 come in a packet at 104"});
  }
};

struct KobukiOptions {
  double stops_by_itself = 0.0;
  double clock_error = 0.0;
  std::int64_t first_stamp = 0;
  std::int64_t first_ticks = 0;
  double wheelbase = 0.230;
  double wheel_radius = 0.035;
  WheelControllerOptions wheels;
  KobukiGyroOptions gyro;
  BatteryOptions battery;

  template <class Visitor>
  void fields(Visitor& v) {
    v("stops_by_itself", stops_by_itself,
      {.unit = "s",
       .min = 0,
       .max = 60,
       .doc = "without a base command for so long it stops; 0: never, as is to be assumed"});
    v("clock_error", clock_error, {.min = -0.01, .max = 0.01, .doc = "its clock goes fast by this share"});
    v("first_stamp", first_stamp,
      {.unit = "ms", .min = 0, .max = 65535, .doc = "of its clock at the start; near 65536 to see it wrap"});
    v("first_ticks", first_ticks,
      {.min = 0, .max = 65535, .doc = "of both encoders at the start; near 65536 to see them wrap"});
    v("wheelbase", wheelbase,
      {.unit = "m", .min = 0.1, .max = 1, .doc = "that it computes with, whatever the robot has"});
    v("wheel_radius", wheel_radius, {.unit = "m", .min = 0.005, .max = 1, .doc = "likewise"});
    v("wheels", wheels, {.doc = "from a base command to turning wheels"});
    v("gyro", gyro, {.doc = "its gyro"});
    v("battery", battery, {.doc = "its pack"});
  }
};

}  // namespace bw::emulators
