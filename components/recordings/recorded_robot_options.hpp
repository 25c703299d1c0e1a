// Parameters of the component that plays a log.
#pragma once

#include <optional>
#include <string>

#include "components/recordings/hold_out.hpp"
#include "components/recordings/synthetic_sensors.hpp"
#include "runtime/base/choice.hpp"
#include "runtime/base/field.hpp"

namespace bw {

enum class LogFormat { husky, mrclam, labyrinth, laser };
constexpr auto choice_table(LogFormat) {
  using enum LogFormat;
  return choices<LogFormat>(
      {{husky, "husky"}, {mrclam, "mrclam"}, {labyrinth, "labyrinth"}, {laser, "laser"}});
}

struct RecordedRobotOptions {
  LogFormat format = LogFormat::husky;
  std::string folder;
  double rate = 1.0;
  double start = 0.0;
  double end = 0.0;
  SyntheticSensorOptions synthetic;
  double datum_latitude = 21.0;
  double datum_longitude = 105.8;
  double variance_per_metre = 5e-4;
  std::string imu_frame = "imu";
  std::string gps_frame = "gps";
  std::string laser_frame = "laser";
  HoldOutOptions hold_out;  // last: GCC 12 warns otherwise of a string that is not initialised

  template <class Visitor>
  void fields(Visitor& v) {
    v("format", format, {.doc = "format of the log"});
    v("folder", folder, {.doc = "folder of the log's files; must be given"});
    v("rate", rate,
      {.min = 0.01,
       .max = 100,
       .doc = "how many times as fast as it was the log is played; speeds are scaled alike"});
    v("start", start, {.unit = "s", .min = 0, .max = 1e6, .doc = "first second of the log that is played"});
    v("end", end, {.unit = "s", .min = 0, .max = 1e6, .doc = "last second of the log; 0: to its end"});
    v("hold_out", hold_out, {.doc = "fixes that go to gps/fix_held_out instead"});
    v("synthetic", synthetic, {.doc = "mrclam: receiver and compass made from the reference"});
    v("datum_latitude", datum_latitude,
      {.unit = "deg", .min = -85, .max = 85, .doc = "mrclam: latitude given to the origin of map"});
    v("datum_longitude", datum_longitude,
      {.unit = "deg", .min = -180, .max = 180, .doc = "mrclam: longitude given to the origin of map"});
    v("variance_per_metre", variance_per_metre,
      {.unit = "m",
       .min = 0,
       .max = 1,
       .doc = "wheel travel variance per metre (k of book 2.2), where the log declares none"});
    v("imu_frame", imu_frame, {.doc = "frame_id of imu"});
    v("gps_frame", gps_frame, {.doc = "frame_id of gps/fix"});
    v("laser_frame", laser_frame, {.doc = "frame_id of scan"});
  }

  std::optional<std::string> violated_rule() const {
    if (folder.empty()) return "folder must name the folder of the log";
    if (end != 0.0 && end <= start) return "end must be 0 or after start";
    return std::nullopt;
  }
};

}  // namespace bw
