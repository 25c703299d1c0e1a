// A satellite receiver: noisy fixes that arrive late and fail under roofs. Frame: map, x east, y north of the
// datum.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "components/model/random.hpp"
#include "runtime/base/field.hpp"
#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw {

struct OutageZone {
  double x_min = 0.0;
  double y_min = 0.0;
  double x_max = 0.0;
  double y_max = 0.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("x_min", x_min, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "one corner of the rectangle, in map"});
    v("y_min", y_min, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "one corner of the rectangle, in map"});
    v("x_max", x_max, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "other corner of the rectangle, in map"});
    v("y_max", y_max, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "other corner of the rectangle, in map"});
  }
};

struct GpsOptions {
  double rate = 1.0;
  double noise = 0.18;
  double latency = 0.0;
  std::vector<OutageZone> outage_zones;
  double datum_latitude = 21.0;
  double datum_longitude = 105.8;
  std::string frame = "gps";

  template <class Visitor>
  void fields(Visitor& v) {
    v("rate", rate, {.unit = "Hz", .min = 0, .max = 100, .doc = "fixes per second; 0: no receiver"});
    v("noise", noise, {.unit = "m", .min = 0, .max = 100, .doc = "standard deviation of a fix per axis"});
    v("latency", latency,
      {.unit = "s", .min = 0, .max = 60, .doc = "time from the measurement of a fix to its arrival"});
    v("outage_zones", outage_zones, {.doc = "where there is no fix"});
    v("datum_latitude", datum_latitude,
      {.unit = "deg", .min = -85, .max = 85, .doc = "latitude of the origin of map, WGS 84"});
    v("datum_longitude", datum_longitude,
      {.unit = "deg", .min = -180, .max = 180, .doc = "longitude of the origin of map, WGS 84"});
    v("frame", frame, {.doc = "frame_id of the fixes"});
  }
};

struct GpsFix {
  Duration measured_at;        ///< world time of the measurement
  bool valid = false;          ///< false: no fix; the position is then meaningless
  Vector2 position{0.0, 0.0};  ///< east, north of the datum [m]
  double latitude = 0.0;       ///< [deg]
  double longitude = 0.0;      ///< [deg]
};

/// Latitude and longitude [deg] of a position `east`, `north` [m] of the datum, by the radii of curvature of
/// WGS 84 there; within 0.2 m of the exact values 1 km away at latitudes below 60 deg.
Vector2 to_latitude_longitude(const Vector2& east_north, double datum_latitude, double datum_longitude);

class Gps {
 public:
  Gps(const GpsOptions& options, Random random) : options_(options), random_(random) {}

  /// Takes a measurement at world time `now`.
  void measure(Duration now, const Vector2& position_in_map);

  /// The fixes whose latency has passed at `now`, oldest first; each is given once.
  std::vector<GpsFix> arrived(Duration now);

 private:
  GpsOptions options_;
  Random random_;
  std::deque<GpsFix> in_transit_;
};

}  // namespace bw
