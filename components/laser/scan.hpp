// A revolution on a fixed grid of beams, as readers of sensor_msgs/LaserScan expect it: as many every time,
// evenly apart, angles rising counter-clockwise from the rear, -pi.
//
// A beam between two samples that see the same surface gets what a straight wall through both has there: 1/r
// is a sine of the angle, so it is 1/r that is interpolated. Surface: their ranges differ by no more than one
// seen at 72 degrees from head-on would make them. Otherwise the sample that is nearer in angle counts; and
// what stands in the beam's own width well before that is not lost.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "components/laser/revolution.hpp"
#include "runtime/base/choice.hpp"
#include "runtime/base/field.hpp"

namespace bw::laser {

/// What a beam says that measured nothing. The device cannot tell sky, black velvet and glass apart.
enum class NoReturn : std::uint8_t {
  free,    ///< +inf: nothing up to range_max, as ROS drivers have it
  unknown  ///< NaN: the robot goes slowly where it cannot see
};
constexpr auto choice_table(NoReturn) {
  return choices<NoReturn>({{NoReturn::free, "free"}, {NoReturn::unknown, "unknown"}});
}

struct ScanOptions {
  std::int64_t beams = 720;
  double range_min = 0.15;
  double range_max = 12.0;
  NoReturn no_return = NoReturn::free;

  template <class Visitor>
  void fields(Visitor& v) {
    v("beams", beams,
      {.min = 90,
       .max = 3600,
       .doc = "of a scan, all round; twice what the device measures in a turn: legs need several"});
    v("range_min", range_min, {.unit = "m", .min = 0.01, .max = 1, .doc = "nearer returns read -inf"});
    v("range_max", range_max, {.unit = "m", .min = 1, .max = 60, .doc = "farther returns read +inf"});
    v("no_return", no_return, {.doc = "a beam that measured nothing: free (+inf) or unknown (NaN)"});
  }
  std::optional<std::string> violated_rule() const {
    if (range_max <= range_min) return "range_max must be greater than range_min";
    return std::nullopt;
  }
};

/// Beam i looks at -pi + i * angle_increment and was taken at `time` + i * time_increment, as well as an even
/// turn tells.
struct Scan {
  Time time;                     ///< of beam 0
  double angle_increment = 0.0;  ///< [rad]
  double time_increment = 0.0;   ///< [s]; negative where the head rotates clockwise
  double scan_time = 0.0;        ///< of a revolution [s]
  std::vector<float> ranges;     ///< [m]; +inf, -inf (too near) and NaN (nobody looked there) by REP 117
  std::vector<float> qualities;  ///< 0 to 63, of the sample nearest in angle
};

Scan to_scan(const Revolution& revolution, const ScanOptions& options);

}  // namespace bw::laser
