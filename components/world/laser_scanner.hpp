// A planar laser scanner: the exact distance along every beam, plus range noise.
//
// The scan is drawn like a picture with a depth buffer: each segment and disc only touches the beams inside
// the angle it fills, and each beam keeps the nearest hit; the map is then searched along every beam up to
// that hit. All beams see the same instant.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "components/model/random.hpp"
#include "components/world/static_scene.hpp"
#include "runtime/base/field.hpp"

namespace bw {

struct LaserOptions {
  double rate = 10.0;
  int beams = 720;
  double field_of_view = 4.71238898038469;
  /// [m] nearer returns read -inf (set by code alone)
  double range_min = 0.05;
  double range_max = 20.0;
  double range_noise = 0.01;
  std::string frame = "laser";

  template <class Visitor>
  void fields(Visitor& v) {
    v("rate", rate, {.unit = "Hz", .min = 0, .max = 1000, .doc = "scans per second; 0: no laser"});
    v("beams", beams, {.min = 2, .max = 20000, .doc = "number of beams of a scan"});
    v("field_of_view", field_of_view,
      {.unit = "rad", .min = 0.01, .max = 6.283185307179586, .doc = "angle from the first to the last beam"});
    v("range_max", range_max, {.unit = "m", .min = 0.1, .max = 1000, .doc = "farther returns read +inf"});
    v("range_noise", range_noise, {.unit = "m", .min = 0, .max = 1, .doc = "standard deviation of a range"});
    v("frame", frame, {.doc = "frame_id of the scans"});
    v.retired({"range_min"}, "a constant of laser_scanner.hpp");
  }

  std::optional<std::string> violated_rule() const {
    if (range_max <= range_min) return "range_max must be greater than range_min";
    return std::nullopt;
  }
};

/// A laser beside the first, with its own topic and mount.
struct MoreLaserOptions : LaserOptions {
  std::string topic = "scan_rear";
  MoreLaserOptions() { frame = "laser_rear"; }

  template <class Visitor>
  void fields(Visitor& v) {
    v("topic", topic, {.doc = "of its scans"});
    LaserOptions::fields(v);
  }
};

/// Beam i looks at angle_min + i * angle_increment in the laser's frame. By REP 117 +inf is no return and
/// -inf a return too near to measure.
struct LaserScan {
  double angle_min = 0.0;        ///< [rad]
  double angle_increment = 0.0;  ///< [rad]
  std::vector<float> ranges;     ///< [m]
};

class LaserScanner {
 public:
  LaserScanner(const LaserOptions& options, Random random);

  /// Scan from the laser's pose in map; `movers` are discs that stand in the way at this instant (legs), in
  /// map.
  LaserScan scan(const StaticScene& scene, const std::vector<Disc>& movers, const Pose2& X_map_laser);

 private:
  void aim(const Pose2& X_map_laser);
  void draw(const Segment& segment);
  void draw(const Disc& disc);
  template <class Shape>
  void draw_between(double first_angle, double width, const Shape& shape);

  LaserOptions options_;
  double angle_min_;
  double angle_increment_;
  Random random_;
  std::vector<Vector2> directions_in_laser_;
  Pose2 X_map_laser_;
  std::vector<Vector2> directions_in_map_;
  std::vector<double> hits_;  ///< nearest hit of each beam so far [m]
};

}  // namespace bw
