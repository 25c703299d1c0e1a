// Parameters of the velocity obstacles (book 5.3) and of the planner that drives by them alone.
#pragma once

#include <cstdint>

#include "components/local_planner/neighbour_fields.hpp"
#include "runtime/base/choice.hpp"
#include "runtime/base/field.hpp"

namespace bw::hrvo {

/// Which movers are trusted to do half of the avoiding.
enum class Reciprocity { known, all };
constexpr auto choice_table(Reciprocity) {
  return choices<Reciprocity>({{Reciprocity::known, "known"}, {Reciprocity::all, "all"}});
}

/// Velocity of the robot that decides on which side a reciprocal mover is passed.
enum class PassingSide {
  actual,     ///< as the paper has it
  preferred,  ///< as the paper's library has it
};
constexpr auto choice_table(PassingSide) {
  return choices<PassingSide>({{PassingSide::actual, "actual"}, {PassingSide::preferred, "preferred"}});
}

struct HrvoOptions {
  double margin = 0.2;
  double neighbour_range = 8.0;
  double view_angle = 4.71238898038469;
  std::int64_t max_neighbours = 10;
  double point_spacing = 0.3;
  Reciprocity reciprocity = Reciprocity::known;
  PassingSide passing_side = PassingSide::actual;
  double time_step = 0.25;
  double sensing_margin = 0.0;
  double hysteresis = 0.1;
  double lookahead = 2.0;
  double margin_worth = 0.7;

  template <class Visitor>
  void fields(Visitor& v) {
    neighbour_fields(*this, v);
    rule_fields(v);
    planner_fields(v);
  }

 private:
  // What it makes of them.
  template <class Visitor>
  void rule_fields(Visitor& v) {
    v("reciprocity", reciprocity,
      {.doc = "who is trusted to do half of the avoiding: movers known to run HRVO, or all movers"});
    v("passing_side", passing_side,
      {.doc = "velocity that decides on which side a reciprocal mover is passed: the actual one (the "
              "paper) or the preferred one (the public library)"});
    v("time_step", time_step,
      {.unit = "s",
       .min = 0.01,
       .max = 5,
       .doc = "time in which an overlap with a neighbour is left; within this time of the goal at v_max "
              "the robot slows down"});
    v("sensing_margin", sensing_margin,
      {.unit = "m/s", .min = 0, .max = 2, .doc = "error of measured velocities that the cones allow for"});
    v("hysteresis", hysteresis,
      {.unit = "m/s",
       .min = 0,
       .max = 2,
       .doc =
           "a way round replaces the last one when its velocity is this much nearer to the preferred one"});
  }
  // What the planner that drives by it alone needs besides.
  template <class Visitor>
  void planner_fields(Visitor& v) {
    v("lookahead", lookahead,
      {.unit = "m",
       .min = 0.2,
       .max = 50,
       .doc = "planner hrvo only: it aims at the point of the plan this far ahead"});
    v("margin_worth", margin_worth,
      {.min = 0,
       .max = 100,
       .doc =
           "planner hrvo only: share of v_max that keeping the whole margin may cost; less is taken where it "
           "costs more"});
  }
};

}  // namespace bw::hrvo
