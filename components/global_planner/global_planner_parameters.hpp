// Parameters of component `global_planner`.
#pragma once

#include <string>
#include <vector>

#include "components/global_planner/options.hpp"
#include "runtime/base/field.hpp"

namespace bw {

struct GlobalPlannerParameters {
  /// [m/s]
  static constexpr double kStandingSpeed = 0.2;
  /// [m]
  static constexpr double kStandingWithin = 5.0;
  bool plan_around_obstacles = false;
  std::vector<std::string> planner_plugins{"GridBased"};
  GlobalPlannerOptions planner;

  template <class Visitor>
  void fields(Visitor& v) {
    v("plan_around_obstacles", plan_around_obstacles,
      {.doc =
           "what the laser saw (topic obstacles) is in the way as well as the map: for places without one"});
    v("planner_plugins", planner_plugins,
      {.doc = "names that actions may call this planner by; with one of them, none is needed"});
    planner.fields(v);
    v.retired({"standing_speed", "standing_within"}, "a constant of global_planner_parameters.hpp");
  }
};

}  // namespace bw
