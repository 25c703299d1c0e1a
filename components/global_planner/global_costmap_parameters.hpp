// Parameters of component `global_costmap`.
#pragma once

#include "components/global_planner/options.hpp"
#include "components/model/footprint_options.hpp"
#include "runtime/base/field.hpp"

namespace bw {

struct GlobalCostmapParameters {
  double publish_frequency = 1.0;  ///< [Hz]
  FootprintOptions footprint;
  GlobalPlannerOptions planner;  ///< what costs follow from: give it the planner's own values

  template <class Visitor>
  void fields(Visitor& v) {
    v("publish_frequency", publish_frequency,
      {.unit = "Hz",
       .min = 0.1,
       .max = 20,
       .doc = "of published_footprint; costs are told when they change"});
    footprint.fields(v);
    planner.cost_fields(v);
  }
};

}  // namespace bw
