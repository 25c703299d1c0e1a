// What a person may tune about the global planner.
#pragma once

#include "runtime/base/field.hpp"

namespace bw {

struct GlobalPlannerOptions {
  double clearance_range = 1.0;     ///< paths keep this far from obstacles where there is room [m]
  double clearance_weight = 3.0;    ///< a metre at the smallest clearance costs 1 + this many free metres
  bool unknown_is_obstacle = true;  ///< never plan through cells nobody has seen
  static constexpr int kOccupiedAt = 65;  ///< smallest occupancy of a map cell that is an obstacle
  /// a start too close to an obstacle moves to a free cell this near [m] (set by code alone)
  double start_tolerance = 0.5;
  double goal_tolerance = 0.25;  ///< a goal that cannot be reached moves to a free cell this near [m]
  /// distance between the poses of a path [m]
  static constexpr double kSpacing = 0.1;

  /// What the map is prepared with.
  template <class Visitor>
  void cost_fields(Visitor& v) {
    v("clearance_range", clearance_range,
      {.unit = "m", .min = 0, .max = 10, .doc = "paths keep this far from obstacles where there is room"});
    v("clearance_weight", clearance_weight,
      {.min = 0, .max = 10, .doc = "price of closeness; raise it to stay in the middle of corridors"});
    v("unknown_is_obstacle", unknown_is_obstacle, {.doc = "never plan through cells nobody has seen"});
    v.retired({"occupied_at"}, "a constant of options.hpp");
  }

  template <class Visitor>
  void fields(Visitor& v) {
    cost_fields(v);
    v("goal_tolerance", goal_tolerance,
      {.unit = "m", .min = 0, .max = 50, .doc = "a goal that cannot be reached may move this far"});
    v.retired({"start_tolerance", "spacing"}, "a constant of options.hpp");
  }
};

}  // namespace bw
