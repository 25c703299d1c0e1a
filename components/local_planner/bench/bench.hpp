// `bandwagon bench teb` and `bandwagon bench crowd`: local planners on scenes, without DDS. Rules: README of
// the scenes.
#pragma once

#include <string>
#include <vector>

#include "components/local_planner/bench/scene_file.hpp"
#include "components/local_planner/planner_factory.hpp"

namespace bw {

/// Which weights the planner optimises with.
enum class BenchWeights {
  file,      ///< the scene file's soft ones and its formulas: comparable costs
  defaults,  ///< the planner's own, which keep the limits
};

struct BenchTebArguments {
  std::string scenes;  ///< path of the scene file
  std::string scene;   ///< name (or its beginning) of one scene; empty: all
  std::string planner = "teb";
  int repetitions = 20;
  std::vector<BenchWeights> weights = {BenchWeights::file, BenchWeights::defaults};
  LocalPlannerOptions options;
  std::string json;  ///< output file; empty: none
};

struct BenchCrowdArguments {
  std::string scenes;
  std::string scene;
  std::string planner = "teb";
  BenchWeights weights = BenchWeights::defaults;
  LocalPlannerOptions options;
  std::string json;
};

/// Open loop: one cold plan and the warm cycles of every scene. Prints a table to stdout, writes JSON.
/// Returns the exit status (0). Throws std::runtime_error on unusable files or names.
int bench_teb(const BenchTebArguments& arguments);

/// Closed loop among walkers that do not react. Prints a table, writes JSON. Returns the exit status (0).
int bench_crowd(const BenchCrowdArguments& arguments);

/// The planner's options for a scene file: its resolution and distances (from the footprint) and, for
/// BenchWeights::file, its weights and formulas.
LocalPlannerOptions options_for(const SceneFile& file, BenchWeights weights, LocalPlannerOptions options,
                                double robot_radius);

/// Scenes whose name begins with `prefix`; throws when there is none.
std::vector<Scene> select_scenes(const SceneFile& file, const std::string& prefix);

}  // namespace bw
