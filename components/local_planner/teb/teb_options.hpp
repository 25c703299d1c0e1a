// Parameters of the planners around the band: when a band is kept, and when a new one competes.
#pragma once

#include "components/local_planner/teb/band_options.hpp"
#include "runtime/base/field.hpp"

namespace bw::teb {

/// What a candidate that touches a mover costs more in the choice; nothing from mover_margin on (theory.md
/// 6.3).
inline constexpr double kMoverMarginCost = 10.0;

struct TebOptions {
  BandOptions band;
  bool include_dynamic_obstacles = true;
  bool allow_init_with_backwards_motion = false;

  template <class Visitor>
  void fields(Visitor& v) {
    v("band", band, {.doc = "the elastic band and its optimiser"});
    v("solver", band.solver,
      {.doc =
           "ceres: the Ceres library; banded: the solver made for bands, of the same result in less time"});
    v("include_dynamic_obstacles", include_dynamic_obstacles,
      {.doc =
           "movers are met where they will be; false: where they are, as if they stood (all planners of the "
           "band but eteb)"});
    v("allow_init_with_backwards_motion", allow_init_with_backwards_motion,
      {.doc = "a first band may drive backward to a goal behind the robot: for one that sees behind it"});
  }
};

}  // namespace bw::teb
