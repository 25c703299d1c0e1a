// What can be wrong with an emulated base, its board and its cable: switched on one by one, while it runs or
// in a window of the run.
#pragma once

#include <cstdint>

#include "components/emulators/emulated_base.hpp"
#include "runtime/base/choice.hpp"
#include "runtime/base/field.hpp"

namespace bw::emulators {

constexpr auto choice_table(Charger) {
  return choices<Charger>({{Charger::none, "none"}, {Charger::dock, "dock"}, {Charger::adapter, "adapter"}});
}

struct Faults {
  double from = 0.0, until = 0.0;
  bool cable_pulled = false, silent = false, hung = false;
  bool garbage = false, half_frames = false, corrupt = false, other_model = false;
  std::int64_t tick_jump = 0;
  double clock_jump = 0.0;
  double runaway_left = 0.0, runaway_right = 0.0;
  bool stalled_left = false, stalled_right = false;
  bool bumper_left = false, bumper_centre = false, bumper_right = false;
  bool cliff_left = false, cliff_centre = false, cliff_right = false;
  bool drop_left = false, drop_right = false;
  double battery_voltage = 0.0;
  Charger charger = Charger::none;
  std::int64_t buttons = 0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("from", from, {.unit = "s", .min = 0, .max = 1e6, .doc = "after its activation the faults begin"});
    v("until", until, {.unit = "s", .min = 0, .max = 1e6, .doc = "they end; 0: never"});
    v("cable_pulled", cable_pulled, {.doc = "no byte gets through, either way"});
    v("silent", silent, {.doc = "it obeys, and answers nothing"});
    v("hung", hung, {.doc = "its firmware stands still: the wheels go on as they do"});
    v("garbage", garbage, {.doc = "it sends as many bytes as it should, all of them random"});
    v("half_frames", half_frames, {.doc = "of what it sends at a time the second half is lost"});
    v("corrupt", corrupt, {.doc = "in what it sends at a time one bit is turned round"});
    v("other_model", other_model, {.doc = "a base of another kind answers; the wheels are left alone"});
    v("tick_jump", tick_jump,
      {.min = -2147483648.0,
       .max = 2147483647.0,
       .doc = "added to both encoder counters, in ticks of the robot"});
    v("clock_jump", clock_jump,
      {.unit = "s", .min = -3600, .max = 3600, .doc = "its clock is wrong by this; a Kobuki has one"});
    v("runaway_left", runaway_left,
      {.unit = "m/s",
       .min = -2,
       .max = 2,
       .doc = "the wheel turns at this, whatever is commanded; 0: it obeys"});
    v("runaway_right", runaway_right, {.unit = "m/s", .min = -2, .max = 2, .doc = "likewise"});
    v("stalled_left", stalled_left, {.doc = "the wheel is held"});
    v("stalled_right", stalled_right, {.doc = "likewise"});
    v("bumper_left", bumper_left, {.doc = "pressed"});
    v("bumper_centre", bumper_centre, {.doc = "likewise"});
    v("bumper_right", bumper_right, {.doc = "likewise"});
    v("cliff_left", cliff_left, {.doc = "no floor below it"});
    v("cliff_centre", cliff_centre, {.doc = "likewise"});
    v("cliff_right", cliff_right, {.doc = "likewise"});
    v("drop_left", drop_left, {.doc = "the wheel hangs down"});
    v("drop_right", drop_right, {.doc = "likewise"});
    v("battery_voltage", battery_voltage,
      {.unit = "V", .min = 0, .max = 60, .doc = "of the pack; 0: as it discharges"});
    v("charger", charger, {.doc = "plugged in: none, dock or adapter"});
    v("buttons", buttons, {.min = 0, .max = 7, .doc = "pressed, as bits"});
  }
};

/// Those that act `since_start` [s].
inline Faults acting(const Faults& faults, double since_start) {
  const bool is_time = since_start >= faults.from && (faults.until <= 0.0 || since_start < faults.until);
  return is_time ? faults : Faults{};
}

/// The body as the board sees it.
Body seen_with(Body body, const Faults& faults);
/// The speeds at which the wheels rotate.
WheelSpeeds with_faults(WheelSpeeds motors, const Faults& faults);

}  // namespace bw::emulators
