// Planners alone through sets of scenes in which others move: T-MPC's corridor (`bench corridor`, protocols.md 8.15) and
// DynaBARN's worlds (`bench dynabarn`, 8.16). Without DDS.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "components/lab/bench/scene_drive.hpp"
#include "components/local_planner/planner_registry.hpp"

namespace bw {

struct SceneSet {
  std::string name;
  std::vector<DriveScene> scenes;
};

struct BenchScenesArguments {
  ScenePrediction prediction = ScenePrediction::constant_velocity;
  std::vector<std::string> planners = {"eteb"};
  std::function<void(PlannerOptions&)> adjust;  ///< last word on the options; may be empty
  int jobs = 1;      ///< drives at a time; above 1 the times are those of their threads
  std::string json;  ///< output file; empty: none
};

/// Each planner first through `empty`. Prints a line for each drive and a table for each set, writes JSON after each.
/// Returns the exit status (0). Throws std::runtime_error on unusable names.
int bench_scenes(const std::vector<SceneSet>& sets, const DriveScene& empty,
                 const BenchScenesArguments& arguments);

}  // namespace bw
