// Parameters of the planner around the band: when a band is kept, when it is trusted, how its start becomes a
// command.
#pragma once

#include "components/local_planner/teb/band_options.hpp"
#include "runtime/parameters/field.hpp"

namespace bw::teb {

struct TebOptions {
  BandOptions band;
  double control_period = 0.1;
  double force_reinit_new_goal_dist = 1.0;
  double force_reinit_new_goal_angular = 0.8;
  double force_reinit_start_dist = 0.5;
  double detour_factor = 1.3;
  double feasibility_check_time = 3.0;
  double feasibility_margin = 0.0;
  double evasion_horizon = 2.0;
  double xy_goal_tolerance = 0.1;
  double yaw_goal_tolerance = 0.1;

  template <class Visitor>
  void fields(Visitor& v) {
    v("band", band, {.doc = "the elastic band and its optimiser"});
    v("control_period", control_period,
      {.unit = "s", .min = 0.005, .max = 1, .doc = "time between calls; the command is for the end of it"});
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
    v("feasibility_check_time", feasibility_check_time,
      {.unit = "s",
       .min = 0,
       .max = 20,
       .doc = "how far ahead the footprint must be free before the robot moves"});
    v("feasibility_margin", feasibility_margin,
      {.unit = "m", .min = 0, .max = 5, .doc = "gap that this check asks for"});
    v("evasion_horizon", evasion_horizon,
      {.unit = "s", .min = 0, .max = 10, .doc = "simulated time of an evasive move; 0: only stop"});
    v("xy_goal_tolerance", xy_goal_tolerance,
      {.unit = "m",
       .min = 0.005,
       .max = 5,
       .doc = "from here the robot only turns to the goal heading and stops"});
    v("yaw_goal_tolerance", yaw_goal_tolerance,
      {.unit = "rad", .min = 0.005, .max = 3.15, .doc = "heading error at which it has arrived"});
  }
};

}  // namespace bw::teb
