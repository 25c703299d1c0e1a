// The robot as every component sees it: geometry, encoders, limits. Section `robot:` of a graph, or a file in config/robots/.
#pragma once

#include <string>

#include "components/model/limits.hpp"
#include "runtime/parameters/field.hpp"

namespace bw {

struct Robot {
  std::string name = "generic";
  double wheel_radius = 0.0762;          ///< [m]
  double wheel_separation = 0.39;        ///< distance b between the wheels [m]
  std::int64_t ticks_per_revolution = 2578;  ///< encoder counts per wheel turn
  double wheel_speed_max = 2.0;          ///< top ground speed of one wheel [m/s]
  double radius = 0.3;                   ///< footprint: disc around base_link [m]
  Limits limits;

  template <class Visitor>
  void fields(Visitor& v) {
    v("name", name, {.doc = "name shown in reports"});
    v("wheel_radius", wheel_radius, {.unit = "m", .min = 0.005, .max = 1, .doc = "radius (not diameter) of a driven wheel"});
    v("wheel_separation", wheel_separation, {.unit = "m", .min = 0.02, .max = 5, .doc = "distance between the driven wheels"});
    v("ticks_per_revolution", ticks_per_revolution, {.min = 4, .max = 10'000'000, .doc = "encoder counts per wheel turn"});
    v("wheel_speed_max", wheel_speed_max,
      {.unit = "m/s", .min = 0.01, .max = 20, .doc = "top ground speed of one wheel; bounds v and omega together"});
    v("radius", radius, {.unit = "m", .min = 0.02, .max = 5, .doc = "radius of the robot's disc footprint"});
    v("limits", limits, {.doc = "motion limits of the base"});
  }
};

}  // namespace bw
