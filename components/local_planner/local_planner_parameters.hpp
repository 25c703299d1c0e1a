// Parameters of the local planner component: which planner, how often, how far; then each planner's own.
#pragma once

#include <string>

#include "components/local_planner/planner_factory.hpp"

namespace bw {

struct LocalPlannerParameters {
  std::string algorithm = "teb";
  double controller_frequency = 10.0;
  double max_global_plan_lookahead_dist = 6.0;
  std::int64_t max_iterations = 100;
  double back_off_margin = 0.15;
  LocalPlannerOptions planners;

  template <class Visitor>
  void fields(Visitor& v) {
    v("algorithm", algorithm, {.choices = planner_names(), .doc = "local planner in use"});
    v("controller_frequency", controller_frequency,
      {.unit = "Hz", .min = 1, .max = 100, .doc = "planning cycles per second"});
    v("max_global_plan_lookahead_dist", max_global_plan_lookahead_dist,
      {.unit = "m",
       .min = 0.5,
       .max = 50,
       .doc = "length of the global plan that is planned on; longer sees people earlier and costs time"});
    v("max_iterations", max_iterations,
      {.min = 1, .max = 10000, .doc = "solver iterations in one cycle, over all candidates"});
    v("back_off_margin", back_off_margin,
      {.unit = "m", .min = 0, .max = 2, .doc = "clearance kept behind the footprint while backing off"});
    planners.fields(v);
  }
};

}  // namespace bw
