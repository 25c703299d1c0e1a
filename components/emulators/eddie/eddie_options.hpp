// What kind of Eddie is emulated: its documents disagree, and boards do too. What no document tells is a
// design choice, and said to be one in the README.
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
  /// it knows WATCH, and stops when nothing is heard for 1 s (set by code alone)
  bool has_watch = true;
  /// the parameter of WATCH is that time in seconds, as in the open firmware (set by code alone)
  bool watch_in_seconds = false;
  /// scale of the values of PING (set by code alone)
  double ping_units_per_mm = 1.0;
  /// [s] from the end of a command to its effect (set by code alone)
  double latency = 0.01;
  /// [m/s^2] until ACC says another one (set by code alone)
  double first_acceleration = 0.5;
  /// [m/s] of a wheel at full power (set by code alone)
  double top_speed = 1.2;
  /// [m] of the wheels, that TURN and HEAD compute with (set by code alone)
  double separation = 0.39;
  BatteryOptions battery{.full = 12.8, .empty = 11.0, .charge = 0.9, .capacity = 7.2, .resistance = 0.05};

  template <class Visitor>
  void fields(Visitor& v) {
    v("board", board, {.doc = "position_controller (36 positions a turn) or quadrature (144)"});
    v("speed_unit", speed_unit,
      {.doc = "what GOSPD and SPD count in: positions per second or per half of one"});
    v.retired({"has_watch", "watch_in_seconds", "ping_units_per_mm", "battery"},
              "a constant of eddie_options.hpp");
  }
};

}  // namespace bw::emulators
