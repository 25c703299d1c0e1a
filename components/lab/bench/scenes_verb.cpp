#include "components/lab/bench/scenes_verb.hpp"

#include <memory>

#include <fmt/format.h>

#include "components/lab/bench/bench_scenes.hpp"
#include "components/lab/bench/corridor/corridor_scene.hpp"
#include "components/lab/bench/dynabarn_world.hpp"
#include "components/lab/bench/planner_overrides.hpp"

namespace bw {
namespace {

struct ScenesVerb {
  BenchScenesArguments arguments;
  std::vector<std::string> set;
};

// Options of both kinds of scenes.
void add_scene_options(cli::Verb& verb, const std::shared_ptr<ScenesVerb>& scenes) {
  verb.option_function(
          "--prediction",
          [scenes](const std::string& name) {
            if (name == to_text(ScenePrediction::roll_out))
              scenes->arguments.prediction = ScenePrediction::roll_out;
          },
          "constant_velocity (default), or roll_out by the others' own rule")
      .one_of({"constant_velocity", "roll_out"});
  verb.option("--planner", scenes->arguments.planners, "Planner names, separated by commas")
      .separated_by_commas();
  verb.option("--set", scenes->set, "Planner parameter, as teb.band.weights.time=2; as often as needed")
      .one_each_time();
  verb.option("--jobs", scenes->arguments.jobs, "Drives at a time; above 1 in thread CPU ms").within(1, 64);
  verb.option("--json", scenes->arguments.json, "Writes the figures here");
  scenes->arguments.adjust = [scenes = scenes.get()](PlannerOptions& options) {
    apply_overrides(options, scenes->set);
  };
}

}  // namespace

void add_corridor(cli::Verb bench) {
  struct Corridor : ScenesVerb {
    std::vector<double> people = {4, 8, 12};
    int drives = 200;
    std::uint64_t first = 1;
  };
  auto corridor = std::make_shared<Corridor>();
  cli::Verb verb = bench.verb("corridor", "T-MPC's corridor: people who come and go make way for the robot");
  verb.option("--people", corridor->people, "How many, separated by commas (4,8,12)").separated_by_commas();
  verb.option("--drives", corridor->drives, "Of each number of people (200)").within(1, 100000);
  verb.option("--first", corridor->first, "Seed of the first (1)");
  add_scene_options(verb, corridor);
  verb.run([corridor] {
    std::vector<SceneSet> sets;
    for (const double people : corridor->people) {
      sets.push_back({fmt::format("corridor, {:.0f} people", people), {}});
      for (int i = 0; i < corridor->drives; ++i)
        sets.back().scenes.push_back(
            corridor_scene(static_cast<int>(people), corridor->first + static_cast<std::uint64_t>(i)));
    }
    return bench_scenes(sets, corridor_scene(0, 1), corridor->arguments);
  });
}

void add_dynabarn(cli::Verb bench) {
  struct DynaBarn : ScenesVerb {
    std::string worlds;
    int phases = 10;
    std::uint64_t first = 1;
  };
  auto dynabarn = std::make_shared<DynaBarn>();
  cli::Verb verb = bench.verb("dynabarn", "DynaBARN's worlds: 20 m among cylinders that move");
  verb.option("--worlds", dynabarn->worlds, "Folder with world_N.csv").required().existing_folder();
  verb.option("--phases", dynabarn->phases,
              "Drives in each world, each begun at other times of the cylinders (10)")
      .within(1, 10000);
  verb.option("--first", dynabarn->first, "Seed of the first (1)");
  add_scene_options(verb, dynabarn);
  verb.run([dynabarn] {
    std::vector<SceneSet> sets;
    for (const DynaBarnWorld& world : read_dynabarn(dynabarn->worlds)) {
      const std::string difficulty = "DynaBARN, " + difficulty_of(world);
      if (sets.empty() || sets.back().name != difficulty) sets.push_back({difficulty, {}});
      for (int i = 0; i < dynabarn->phases; ++i)
        sets.back().scenes.push_back(dynabarn_scene(world, dynabarn->first + static_cast<std::uint64_t>(i)));
    }
    return bench_scenes(sets, dynabarn_scene({"world_0", {}}, 1), dynabarn->arguments);
  });
}

}  // namespace bw
