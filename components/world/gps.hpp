// A satellite receiver: noisy fixes that arrive late and fail under roofs. Frame: map, x east, y north of the
// datum.
#pragma once

#include <deque>
#include <vector>

#include "components/model/random.hpp"
#include "runtime/base/field.hpp"
#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw {

/// Of a rectangle two opposite corners, in map [m].
struct OutageZone {
  double x_min = 0.0;
  double y_min = 0.0;
  double x_max = 0.0;
  double y_max = 0.0;
};

struct GpsOptions {
  double rate = 1.0;
  double noise = 0.18;
  /// [s] time from the measurement of a fix to its arrival (set by code alone)
  double latency = 0.0;
  /// where there is no fix (set by code alone)
  std::vector<OutageZone> outage_zones;
  double datum_latitude = 21.0;
  double datum_longitude = 105.8;
  /// frame_id of the fixes, as the robot files have it
  static constexpr const char* kFrame = "gps";

  template <class Visitor>
  void fields(Visitor& v) {
    v("rate", rate, {.unit = "Hz", .min = 0, .max = 100, .doc = "fixes per second; 0: no receiver"});
    v("noise", noise, {.unit = "m", .min = 0, .max = 100, .doc = "standard deviation of a fix per axis"});
    v("datum_latitude", datum_latitude,
      {.unit = "deg", .min = -85, .max = 85, .doc = "latitude of the origin of map, WGS 84"});
    v("datum_longitude", datum_longitude,
      {.unit = "deg", .min = -180, .max = 180, .doc = "longitude of the origin of map, WGS 84"});
    v.retired({"latency", "outage_zones", "frame"}, "a constant of gps.hpp");
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
