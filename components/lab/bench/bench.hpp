// `bandwagon bench teb` and `bandwagon bench crowd`: local planners on scenes, without DDS. Rules: README of
// the scenes.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "components/lab/bench/scene_file.hpp"
#include "components/lab/report/document.hpp"
#include "components/local_planner/planner_registry.hpp"
#include "components/local_planner/teb/band_options.hpp"

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
  bool with_samples = false;  ///< every cycle of the first run goes into the JSON
  std::vector<BenchWeights> weights = {BenchWeights::file, BenchWeights::defaults};
  std::function<void(PlannerOptions&)> adjust;  ///< last word on the options; may be empty
  std::string json;                             ///< output file; empty: none
};

struct BenchCrowdArguments {
  std::string scenes;            ///< path; may be empty when scenes are generated
  int generate = 0;              ///< this many scenes of crowd_generator.hpp instead of those of the file
  std::uint64_t first_seed = 1;  ///< of the generated ones
  std::vector<double>
      densities;  ///< of generated ones, persons per square metre, one crowd each; empty: 6, 10 or 14 walkers
  std::vector<WalkersManner> walkers = {WalkersManner::straight};  ///< one crowd each
  std::string scene;  ///< name (or its beginning) of one scene; empty: all
  std::vector<std::string> planners = {"teb"};
  BenchWeights weights = BenchWeights::defaults;
  std::function<void(PlannerOptions&)> adjust;  ///< last word on the options; may be empty
  int jobs = 1;               ///< episodes at a time; above 1 the times are those of their threads
  bool with_samples = false;  ///< every period of every drive goes into the JSON
  std::string write_scenes;   ///< scenes driven are written here as YAML, of one crowd; empty: not
  std::string against;        ///< the planner that the others are held against; empty: the first
  std::string failures;       ///< index.html in this folder shows drives that failed; empty: none
  report::Writer write_page;  ///< makes it
  std::string json;           ///< output file; empty: none
};

/// Open loop: one cold plan and the warm cycles of every scene. Prints a table to stdout, writes JSON.
/// Returns the exit status (0). Throws std::runtime_error on unusable files or names.
int bench_teb(const BenchTebArguments& arguments);

/// Closed loop among walkers, one crowd and one planner after the other. Prints tables, writes JSON: of one
/// planner {planner, episodes, summary}, of several {planners: [that, ...], comparison}, of several crowds
/// {crowds: [{crowd, density, walkers, planners, comparison}, ...]}. Returns the exit status (0). Throws
/// std::runtime_error on unusable files or names.
int bench_crowd(const BenchCrowdArguments& arguments);

/// The planner's options for a scene file: its resolution and distances (from the footprint) and, for
/// BenchWeights::file, its weights and formulas.
PlannerOptions options_for(const SceneFile& file, BenchWeights weights, PlannerOptions options,
                           double robot_radius);

/// The band of the planners that have one.
teb::BandOptions& band_of(PlannerOptions& options);
const teb::BandOptions& band_of(const PlannerOptions& options);

/// Scenes whose name begins with `prefix`; throws when there is none.
std::vector<Scene> select_scenes(const SceneFile& file, const std::string& prefix);

}  // namespace bw
