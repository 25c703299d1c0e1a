// Is a planning problem fit to be planned on? Shared by every local planner.
#pragma once

#include <string>

#include "components/model/planning.hpp"

namespace bw {

/// Empty when every number is finite and in a sensible range; else one sentence that names what is not.
std::string fault_of(const PlanningProblem& problem);

}  // namespace bw
