// Walls and boxes written in a graph. The world and the map server read the same lists, so that one YAML
// anchor serves both.
#pragma once

#include <array>

#include "runtime/base/field.hpp"
#include "runtime/base/pose2.hpp"

namespace bw {

struct WallOptions {
  double x1 = 0.0;
  double y1 = 0.0;
  double x2 = 0.0;
  double y2 = 0.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("x1", x1, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "one end, in map"});
    v("y1", y1, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "one end, in map"});
    v("x2", x2, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "other end, in map"});
    v("y2", y2, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "other end, in map"});
  }
};

struct BoxOptions {
  double x = 0.0;
  double y = 0.0;
  double length = 1.0;
  double width = 1.0;
  double theta = 0.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("x", x, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "centre, in map"});
    v("y", y, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "centre, in map"});
    v("length", length, {.unit = "m", .min = 0.001, .max = 1e4, .doc = "edge along its own x"});
    v("width", width, {.unit = "m", .min = 0.001, .max = 1e4, .doc = "edge along its own y"});
    v("theta", theta, {.unit = "rad", .min = -6.3, .max = 6.3, .doc = "turn of the box"});
  }

  /// Corners in map, counter-clockwise.
  std::array<Vector2, 4> corners() const {
    const Pose2 X_map_box{x, y, theta};
    const double a = length / 2.0;
    const double b = width / 2.0;
    return {X_map_box * Vector2(-a, -b), X_map_box * Vector2(a, -b), X_map_box * Vector2(a, b),
            X_map_box * Vector2(-a, b)};
  }
};

}  // namespace bw
