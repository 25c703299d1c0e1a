// Parameters of the planner `orca` (theory.md 5.6).
#pragma once

#include "components/local_planner/hrvo/hrvo_options.hpp"
#include "components/local_planner/neighbour_fields.hpp"
#include "runtime/base/field.hpp"

namespace bw::orca {

struct OrcaOptions {
  double margin = 0.2;
  double neighbour_range = 10.0;
  hrvo::Reciprocity reciprocity = hrvo::Reciprocity::known;
  double horizon = 5.0;
  double static_horizon = 2.0;
  double lookahead = 2.0;

  template <class Visitor>
  void fields(Visitor& v) {
    neighbour_fields(*this, v);
    v("reciprocity", reciprocity,
      {.doc =
           "who is trusted to do half of the avoiding: movers known to do so, or all movers; all where everybody does"});
    v("horizon", horizon,
      {.unit = "s",
       .min = 0.1,
       .max = 60,
       .doc =
           "velocities keep clear of movers for so long; longer starts to avoid earlier, and leaves less room"});
    v("static_horizon", static_horizon,
      {.unit = "s",
       .min = 0.1,
       .max = 60,
       .doc = "velocities keep clear of what stands for so long; raise it to keep away from walls"});
    v("lookahead", lookahead,
      {.unit = "m",
       .min = 0.2,
       .max = 50,
       .doc = "it aims at the point of the plan this far ahead; lower it to keep closer to the plan"});
  }
};

}  // namespace bw::orca
