// Parameters of component `global_planner`.
#pragma once

#include <string>
#include <vector>

#include "components/global_planner/options.hpp"
#include "runtime/base/field.hpp"

namespace bw {

struct GlobalPlannerParameters {
  double standing_speed = 0.2;   ///< [m/s]
  double standing_within = 5.0;  ///< [m]
  bool plan_around_obstacles = false;
  std::vector<std::string> planner_plugins{"GridBased"};
  GlobalPlannerOptions planner;

  template <class Visitor>
  void fields(Visitor& v) {
    v("standing_speed", standing_speed,
      {.unit = "m/s",
       .min = 0,
       .max = 5,
       .doc = "confirmed people slower than this stand in the way; 0: none do"});
    v("standing_within", standing_within,
      {.unit = "m", .min = 0, .max = 100, .doc = "only tracks this near to the start count"});
    v("plan_around_obstacles", plan_around_obstacles,
      {.doc =
           "what the laser saw (topic obstacles) is in the way as well as the map: for places without one"});
    v("planner_plugins", planner_plugins,
      {.doc = "names that actions may call this planner by; with one of them, none is needed"});
    planner.fields(v);
  }
};

}  // namespace bw
