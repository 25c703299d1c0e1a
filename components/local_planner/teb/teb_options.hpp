// Parameters of the planners around the band: when a band is kept, and when a new one competes.
#pragma once

#include "components/local_planner/teb/band_options.hpp"
#include "runtime/base/field.hpp"

namespace bw::teb {

struct TebOptions {
  BandOptions band;
  double force_reinit_new_goal_dist = 1.0;
  double force_reinit_new_goal_angular = 0.8;
  double force_reinit_start_dist = 0.5;
  double detour_factor = 1.3;
  double mover_margin_cost = 10.0;
  bool include_dynamic_obstacles = true;
  bool allow_init_with_backwards_motion = false;

  template <class Visitor>
  void fields(Visitor& v) {
    v("band", band, {.doc = "the elastic band and its optimiser"});
    v("solver", band.solver,
      {.doc =
           "ceres: the Ceres library; banded: the solver made for bands, of the same result in less time"});
    v("force_reinit_new_goal_dist", force_reinit_new_goal_dist,
      {.unit = "m", .min = 0, .max = 100, .doc = "a goal that moved further starts a new band"});
    v("force_reinit_new_goal_angular", force_reinit_new_goal_angular,
      {.unit = "rad", .min = 0, .max = 3.15, .doc = "a goal heading that turned further starts a new band"});
    v("force_reinit_start_dist", force_reinit_start_dist,
      {.unit = "m", .min = 0, .max = 100, .doc = "a robot further from its band starts a new one"});
    v("detour_factor", detour_factor,
      {.min = 1,
       .max = 100,
       .doc = "a band this many times slower than the free way is compared with a new one"});
    v("mover_margin_cost", mover_margin_cost,
      {.min = 0,
       .max = 1e4,
       .doc =
           "what a candidate that touches a mover costs more in the choice; nothing from mover_margin on"});
    v("include_dynamic_obstacles", include_dynamic_obstacles,
      {.doc =
           "movers are met where they will be; false: where they are, as if they stood (all planners of the "
           "band but eteb)"});
    v("allow_init_with_backwards_motion", allow_init_with_backwards_motion,
      {.doc = "a first band may drive backward to a goal behind the robot"});
  }
};

}  // namespace bw::teb
