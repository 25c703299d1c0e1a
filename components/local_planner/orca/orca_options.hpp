// Parameters of the planner `orca` (book 5.6).
#pragma once

#include <cstdint>
#include <numbers>

#include "components/local_planner/hrvo/hrvo_options.hpp"
#include "components/local_planner/neighbour_fields.hpp"
#include "runtime/base/field.hpp"

namespace bw::orca {

struct OrcaOptions {
  double margin = 0.2;
  double neighbour_range = 10.0;
  double view_angle = 2.0 * std::numbers::pi;
  std::int64_t max_neighbours = 10;
  double point_spacing = 0.3;
  hrvo::Reciprocity reciprocity = hrvo::Reciprocity::known;
  double horizon = 5.0;
  double static_horizon = 2.0;
  double time_step = 0.25;
  double lookahead = 2.0;

  template <class Visitor>
  void fields(Visitor& v) {
    neighbour_fields(*this, v);
    rule_fields(v);
  }

 private:
  // What it makes of them.
  template <class Visitor>
  void rule_fields(Visitor& v) {
    v("reciprocity", reciprocity,
      {.doc = "who is trusted to do half of the avoiding: movers known to do so, or all movers"});
    v("horizon", horizon,
      {.unit = "s",
       .min = 0.1,
       .max = 60,
       .doc =
           "velocities keep clear of movers for so long; longer starts to avoid earlier, and leaves less room"});
    v("static_horizon", static_horizon,
      {.unit = "s", .min = 0.1, .max = 60, .doc = "velocities keep clear of what stands for so long"});
    v("time_step", time_step,
      {.unit = "s",
       .min = 0.01,
       .max = 5,
       .doc =
           "time in which an overlap with a mover is left; within this time of the goal at v_max the robot "
           "slows down"});
    v("lookahead", lookahead,
      {.unit = "m", .min = 0.2, .max = 50, .doc = "it aims at the point of the plan this far ahead"});
  }
};

}  // namespace bw::orca
