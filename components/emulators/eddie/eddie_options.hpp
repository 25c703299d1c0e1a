// What kind of Eddie is emulated: its documents disagree, and boards do too. What no document tells is a design choice, and said to
// be one in the README.
#pragma once

#include "components/emulators/battery.hpp"
#include "runtime/base/choice.hpp"
#include "runtime/base/field.hpp"

namespace bw::emulators {

enum class EddieBoard {
  position_controller,  ///< green, firmware 1.1: 36 positions a turn, speeds of TRVL up to 7F, ACC up to FF
  quadrature            ///< blue, firmware 1.3: 144 positions a turn, up to FF and 7FF
};
constexpr auto choice_table(EddieBoard) {
  return choices<EddieBoard>(
      {{EddieBoard::position_controller, "position_controller"}, {EddieBoard::quadrature, "quadrature"}});
}

enum class SpeedUnit { per_second, per_half_second };
constexpr auto choice_table(SpeedUnit) {
  return choices<SpeedUnit>(
      {{SpeedUnit::per_second, "per_second"}, {SpeedUnit::per_half_second, "per_half_second"}});
}

struct EddieOptions {
  EddieBoard board = EddieBoard::quadrature;
  SpeedUnit speed_unit = SpeedUnit::per_second;
  bool has_watch = true;
  bool watch_in_seconds = false;
  double ping_units_per_mm = 1.0;
  double latency = 0.01;
  double first_acceleration = 0.5;
  double top_speed = 1.2;
  double separation = 0.39;
  BatteryOptions battery{.full = 12.8, .empty = 11.0, .charge = 0.9, .capacity = 7.2, .resistance = 0.05};

  template <class Visitor>
  void fields(Visitor& v) {
    v("board", board, {.doc = "position_controller (36 positions a turn) or quadrature (144)"});
    v("speed_unit", speed_unit,
      {.doc = "what GOSPD and SPD count in: positions per second or per half of one"});
    v("has_watch", has_watch, {.doc = "it knows WATCH, and stops when nothing is heard for 1 s"});
    v("watch_in_seconds", watch_in_seconds,
      {.doc = "the parameter of WATCH is that time in seconds, as in the open firmware"});
    v("ping_units_per_mm", ping_units_per_mm,
      {.min = 0.01, .max = 1000, .doc = "scale of the values of PING"});
    v("latency", latency,
      {.unit = "s", .min = 0, .max = 1, .doc = "from the end of a command to its effect"});
    v("first_acceleration", first_acceleration,
      {.unit = "m/s^2", .min = 0.01, .max = 10, .doc = "until ACC says another one"});
    v("top_speed", top_speed, {.unit = "m/s", .min = 0.1, .max = 5, .doc = "of a wheel at full power"});
    v("separation", separation,
      {.unit = "m", .min = 0.05, .max = 2, .doc = "of the wheels, that TURN and HEAD compute with"});
    v("battery", battery, {.doc = "its pack"});
  }
};

}  // namespace bw::emulators
