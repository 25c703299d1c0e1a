// Parameters of an Eddie: what its documents leave open or say differently stands in the robot file.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/choice.hpp"
#include "runtime/base/field.hpp"

namespace bw::eddie {

enum class PositionsPer { second, half_second };
constexpr auto choice_table(PositionsPer) {
  return choices<PositionsPer>(
      {{PositionsPer::second, "second"}, {PositionsPer::half_second, "half_second"}});
}

struct RateOptions {
  double drive = 25.0, counts = 40.0, analog = 5.0, sonar = 5.0;
};

struct EddieOptions {
  PositionsPer positions_per = PositionsPer::second;
  bool watch = true;
  double acceleration = 3.0;
  /// [s] longest wait for a reply (set by code alone)
  double reply_timeout = 0.08;
  /// [s] without a reply after which the base counts as lost (set by code alone)
  double silence = 0.2;
  double velocity_window = 0.12;
  RateOptions rates;
  std::vector<std::int64_t> sonar_pins;
  std::vector<std::string> sonar_frames;
  double sonar_metres_per_unit = 0.001;
  std::vector<std::int64_t> infrared_channels;
  std::vector<std::string> infrared_frames;
  double infrared_scale = 0.60495;
  double infrared_power = 1.1904;
  /// [V] of ADC channel 8, behind its divider (set by code alone)
  double supply_volts_per_unit = 3.21 / 819.0;
  /// [V] warned of below, of a lead battery of 12 V; robot_base.battery sets others
  static constexpr double kBatteryLow = 11.5;
  /// [V] not driven below, likewise: six cells of 1.8 V
  static constexpr double kBatteryEmpty = 10.8;

  std::optional<std::string> violated_rule() const {
    if (sonar_pins.size() != sonar_frames.size()) return "sonar_pins and sonar_frames must be as many";
    if (infrared_channels.size() != infrared_frames.size())
      return "infrared_channels and infrared_frames must be as many";
    if (std::ranges::any_of(sonar_pins, [](std::int64_t pin) { return pin < 0 || pin > 15; }))
      return "sonar_pins must be 0 to 15";
    if (std::ranges::adjacent_find(sonar_pins, std::ranges::greater_equal{}) != sonar_pins.end())
      return "sonar_pins must ascend, as PING tells them";
    if (std::ranges::any_of(infrared_channels,
                            [](std::int64_t channel) { return channel < 1 || channel > 7; }))
      return "infrared_channels must be 1 to 7; 8 is the supply";
    return std::nullopt;
  }

  template <class Visitor>
  void fields(Visitor& v) {
    v("positions_per", positions_per,
      {.doc =
           "what GOSPD counts positions per; the documents say both, and the driver tells when it is wrong"});
    v("watch", watch, {.doc = "the board stops its motors when it hears nothing for a second (WATCH)"});
    v("acceleration", acceleration,
      {.unit = "m/s^2",
       .min = 0.05,
       .max = 20,
       .doc =
           "ramp of the board (ACC); above stop_deceleration of the robot, so that stops are as robot_base means them"});
    v("velocity_window", velocity_window,
      {.unit = "s",
       .min = 0,
       .max = 1,
       .doc = "time over which speed is averaged at least: a count is 3.3 mm, or 13 mm"});
    v("sonar_pins", sonar_pins, {.min = 0, .max = 15, .doc = "with a PING))) sensor, ascending"});
    v("sonar_frames", sonar_frames, {.doc = "their frames, of the robot's sensors"});
    v("sonar_metres_per_unit", sonar_metres_per_unit,
      {.unit = "m",
       .min = 1e-7,
       .max = 0.1,
       .doc = "of PING; mm by the open firmware, 1/470.2 mm by the maker's document"});
    v("infrared_channels", infrared_channels, {.min = 1, .max = 7, .doc = "of ADC with an infrared ranger"});
    v("infrared_frames", infrared_frames, {.doc = "their frames, of the robot's sensors"});
    v("infrared_scale", infrared_scale,
      {.unit = "m",
       .min = 0.01,
       .max = 10,
       .doc = "range at 1 V: range = infrared_scale * volts ^ -infrared_power"});
    v("infrared_power", infrared_power,
      {.min = 0.1, .max = 5, .doc = "as above; the defaults suit a Sharp GP2Y0A02"});
    v.retired(
      {"reply_timeout", "silence", "rates", "supply_volts_per_unit", "battery_low", "battery_empty"},
      "a constant of eddie_options.hpp");
  }
};

}  // namespace bw::eddie
