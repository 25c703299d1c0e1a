// The recovery "back off": straight back, slowly, while nothing is behind.
#pragma once

#include "components/model/planning.hpp"

namespace bw {

/// A backward command at most at v_back_max, as fast as allows to stop within the free distance behind the
/// robot; a stop when that way is shorter than `margin` [m] beyond the footprint. Status infeasible names
/// what is behind.
PlanningResult back_off(const PlanningProblem& problem, double period, double margin);

}  // namespace bw
