// Parameters of the velocity obstacles (theory.md 5.3) and of the planner that drives by them alone.
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

struct HrvoOptions {
  double margin = 0.2;
  double lookahead = 2.0;

  // Set by code: whom `orca` looks at, and what the paper and its library have it do.
  double neighbour_range = 8.0;                  ///< neighbours further away are not looked at [m]
  Reciprocity reciprocity = Reciprocity::known;  ///< who is trusted to do half of the avoiding
  double view_angle = 4.71238898038469;          ///< centred on the heading: 270 degrees, Table 3.1
  std::int64_t max_neighbours =
      10;  ///< the nearest movers, and as many static obstacles: neither crowds out the other
  PassingSide passing_side = PassingSide::actual;
  double sensing_margin = 0.0;  ///< error of measured velocities that the cones allow for [m/s]

  template <class Visitor>
  void fields(Visitor& v) {
    neighbour_fields(*this, v);
  }
};

/// Obstacle points closer than this to a nearer one are left out, at most the radius they get [m]: three in a
/// robot's width.
inline constexpr double kPointSpacing = 0.3;
/// In this time an overlap with a neighbour is left; within it of the goal at v_max the robot slows down: a
/// planning cycle [s].
inline constexpr double kTimeStep = 0.25;

}  // namespace bw::hrvo
