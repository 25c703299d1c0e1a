// What a planner was asked and answered at one moment of the crossing drive.
#pragma once

#include <optional>
#include <string_view>

#include "components/lab/experiments/crossing_scene.hpp"
#include "components/local_planner/planner_registry.hpp"
#include "components/model/planning.hpp"

namespace bw::figures {

struct CrossingMoment {
  PlanningProblem problem;
  PlanningResult result;
};

/// Seed 1, the first planner call at or after `time` [s] of the drive by that planner.
CrossingMoment crossing_moment(std::string_view planner, const PlannerOptions& options, double time);

}  // namespace bw::figures
