// Parameters of the planner `orca` (theory.md 5.6).
#pragma once

#include "components/local_planner/hrvo/hrvo_options.hpp"
#include "components/local_planner/neighbour_fields.hpp"
#include "runtime/base/field.hpp"

namespace bw::orca {

struct OrcaOptions {
  double margin = 0.2;
  /// [m] neighbours further away are not looked at: CrowdNav's value
  static constexpr double kNeighbourRange = 10.0;
  double horizon = 5.0;
  /// [s] velocities keep clear of what stands for so long
  static constexpr double kStaticHorizon = 2.0;
  double lookahead = 2.0;

  /// who is trusted to do half of the avoiding (set by code alone)
  hrvo::Reciprocity reciprocity = hrvo::Reciprocity::known;

  template <class Visitor>
  void fields(Visitor& v) {
    neighbour_fields(*this, v);
    v("horizon", horizon,
      {.unit = "s",
       .min = 0.1,
       .max = 60,
       .doc =
           "velocities keep clear of movers for so long; longer starts to avoid earlier, and leaves less room"});
    v.retired({"static_horizon"}, "a constant of orca_options.hpp");
  }
};

}  // namespace bw::orca
