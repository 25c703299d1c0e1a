// Parameters of planners as a command line names them.
#pragma once

#include <string>
#include <vector>

#include "components/local_planner/planner_registry.hpp"

namespace bw {

/// `set`: name=value, as teb.band.dt_ref=0.28. Throws what reading parameters throws.
void apply_overrides(PlannerOptions& options, const std::vector<std::string>& set);

}  // namespace bw
