// What can be wrong with an emulated base, its board and its cable: switched on one by one while it runs, by hand or by the graph
// (`faults:`, kind parameters).
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
  bool cable_pulled = false, silent = false, hung = false;
  bool garbage = false;
  /// of what it sends at a time the second half is lost (set by code alone)
  bool half_frames = false;
  /// in what it sends at a time one bit is changed (set by code alone)
  bool corrupt = false;
  bool other_model = false;
  /// added to both encoder counters, in ticks of the robot (set by code alone)
  std::int64_t tick_jump = 0;
  /// [s] its clock is wrong by this; a Kobuki has one (set by code alone)
  double clock_jump = 0.0;
  double runaway_left = 0.0, runaway_right = 0.0;
  /// the wheel is held, as by a wall of the world (set by code alone)
  bool stalled_left = false, stalled_right = false;
  /// pressed, as by what stands in the world (set by code alone)
  bool bumper_left = false, bumper_centre = false, bumper_right = false;
  /// no floor below it (set by code alone, but for cliff_centre)
  bool cliff_left = false, cliff_centre = false, cliff_right = false;
  /// the wheel hangs down (drop_right is set by code alone)
  bool drop_left = false, drop_right = false;
  double battery_voltage = 0.0;
  Charger charger = Charger::none;
  /// pressed, as bits (set by code alone)
  std::int64_t buttons = 0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("cable_pulled", cable_pulled, {.doc = "no byte gets through, either way"});
    v("silent", silent, {.doc = "it obeys, and answers nothing"});
    v("hung", hung, {.doc = "its firmware stands still: the wheels go on as they do"});
    v("garbage", garbage, {.doc = "it sends as many bytes as it should, all of them random"});
    v("other_model", other_model, {.doc = "a base of another kind answers; the wheels are left alone"});
    v("runaway_left", runaway_left,
      {.unit = "m/s",
       .min = -2,
       .max = 2,
       .doc = "the wheel turns at this, whatever is commanded; 0: it obeys"});
    v("runaway_right", runaway_right, {.unit = "m/s", .min = -2, .max = 2, .doc = "likewise"});
    v("cliff_centre", cliff_centre, {.doc = "likewise"});
    v("drop_left", drop_left, {.doc = "the wheel hangs down"});
    v("battery_voltage", battery_voltage,
      {.unit = "V", .min = 0, .max = 60, .doc = "of the pack; 0: as it discharges"});
    v("charger", charger, {.doc = "plugged in: none, dock or adapter"});
    v.retired(
        {"half_frames", "corrupt", "tick_jump", "clock_jump", "stalled_left", "stalled_right", "bumper_left",
         "bumper_centre", "bumper_right", "cliff_left", "cliff_right", "drop_right", "buttons"},
        "set by code alone, in faults.hpp");
    v.retired({"from", "until"}, "section faults of the graph: kind parameters, from, for");
  }
};

/// The body as the board sees it.
Body seen_with(Body body, const Faults& faults);
/// The speeds at which the wheels rotate.
WheelSpeeds with_faults(WheelSpeeds motors, const Faults& faults);

}  // namespace bw::emulators
