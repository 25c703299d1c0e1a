// How fast the robot may drive towards a goal that it stops at.
#pragma once

#include "components/model/planning.hpp"

namespace bw::dwa {

/// [m/s] from which it can brake before the end of the problem's plan when braking begins `late` [s] from
/// now; with `on_one_arc` also no faster than turning into the end on one arc allows, whose radius is d / (2
/// sin e) for an end d away at e from the heading. v_max on the way to another goal.
double speed_towards_end(const PlanningProblem& problem, bool on_one_arc, double late);

}  // namespace bw::dwa
