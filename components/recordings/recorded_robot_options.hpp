// Parameters of the component that plays a bag.
#pragma once

#include <optional>
#include <string>

#include "components/recordings/drive_topics.hpp"
#include "components/recordings/hold_out.hpp"
#include "components/recordings/synthetic_sensors.hpp"
#include "runtime/base/field.hpp"

namespace bw {

struct RecordedRobotOptions {
  std::string bag;
  DriveTopics topics;
  double rate = 1.0;
  double start = 0.0;
  double end = 0.0;
  bool make_sensors = false;
  SyntheticSensorOptions synthetic;
  /// [deg] make_sensors: latitude given to the origin of map, as config/graphs/recorded_robot.yaml tells the
  /// localization
  static constexpr double kDatumLatitude = 21.0;
  /// [deg] make_sensors: its longitude
  static constexpr double kDatumLongitude = 105.8;
  double variance_per_metre = 5e-4;
  bool end_run = true;
  HoldOutOptions hold_out;  // last: GCC 12 warns otherwise of a string that is not initialised

  template <class Visitor>
  void fields(Visitor& v) {
    v("bag", bag, {.doc = "bag that is played: file or folder; must be given"});
    v("topics", topics, {.doc = "where the bag has what; empty: it is not read"});
    v("rate", rate,
      {.min = 0.01,
       .max = 100,
       .doc = "how many times as fast as it was the bag is played; speeds are scaled alike"});
    v("start", start, {.unit = "s", .min = 0, .max = 1e6, .doc = "first second of the bag that is played"});
    v("end", end, {.unit = "s", .min = 0, .max = 1e6, .doc = "last second of the bag; 0: to its end"});
    v("end_run", end_run, {.doc = "the run is over a second after the last that is played"});
    v("hold_out", hold_out, {.doc = "fixes that go to gps/fix_held_out instead"});
    v("make_sensors", make_sensors,
      {.doc = "for a bag with a reference and without them: a receiver and a compass are made from it"});
    v("synthetic", synthetic, {.doc = "rates and noise of what make_sensors makes"});
    v("variance_per_metre", variance_per_metre,
      {.unit = "m",
       .min = 0,
       .max = 1,
       .doc = "wheel travel variance per metre (k of model/README.md 2.2), where the bag declares none"});
    v.retired({"datum_latitude", "datum_longitude"}, "a constant of recorded_robot_options.hpp");
  }

  std::optional<std::string> violated_rule() const {
    if (bag.empty()) return "bag must name the bag that is played";
    if (end != 0.0 && end <= start) return "end must be 0 or after start";
    return std::nullopt;
  }
};

}  // namespace bw
