#include "components/lab/bench/scenes_verb.hpp"

#include <memory>

#include <fmt/format.h>

#include "components/lab/bench/bench_scenes.hpp"
#include "components/lab/bench/corridor/corridor_scene.hpp"
#include "components/lab/bench/dynabarn_world.hpp"
#include "components/lab/bench/flows/flow_scenes.hpp"
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
    std::string walkers = "social";
    std::vector<double> people = {4, 8, 12};
    int drives = 200;
    std::uint64_t first = 1;
  };
  auto corridor = std::make_shared<Corridor>();
  cli::Verb verb = bench.verb("corridor", "T-MPC's corridor: people who come and go make way for the robot");
  verb.option("--people", corridor->people, "How many, separated by commas (4,8,12)").separated_by_commas();
  verb.option(
          "--walkers", corridor->walkers,
          "social (default: they make way), straight (they keep their velocity), or crossing (the same, across; fixed ones "
          "and 16 people)")
      .one_of({"social", "straight", "crossing"});
  verb.option("--drives", corridor->drives, "Of each number of people (200)").within(1, 100000);
  verb.option("--first", corridor->first, "Seed of the first (1)");
  add_scene_options(verb, corridor);
  verb.run([corridor] {
    std::vector<SceneSet> sets;
    const auto add = [&](std::string name, const auto& scene_of) {
      sets.push_back({std::move(name), corridor_scene(0, 1)});
      for (int i = 0; i < corridor->drives; ++i)
        sets.back().scenes.push_back(scene_of(corridor->first + static_cast<std::uint64_t>(i)));
    };
    if (corridor->walkers == "crossing") {
      sets.push_back({"crossings, fixed", corridor_scene(0, 1), fixed_crossings()});
      add(fmt::format("crossing, {} people", kCrossingPeople), crossing_scene);
      return bench_scenes(sets, corridor->arguments);
    }
    const bool straight = corridor->walkers == "straight";
    for (const double number : corridor->people) {
      const int people = static_cast<int>(number);
      add(fmt::format("corridor, {} people{}", people, straight ? ", straight" : ""),
          [&](std::uint64_t seed) {
            return straight ? straight_corridor_scene(people, seed) : corridor_scene(people, seed);
          });
    }
    return bench_scenes(sets, corridor->arguments);
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
      if (sets.empty() || sets.back().name != difficulty)
        sets.push_back({difficulty, dynabarn_scene({"world_0", {}}, 1)});
      for (int i = 0; i < dynabarn->phases; ++i)
        sets.back().scenes.push_back(dynabarn_scene(world, dynabarn->first + static_cast<std::uint64_t>(i)));
    }
    return bench_scenes(sets, dynabarn->arguments);
  });
}

void add_flows(cli::Verb bench) {
  struct Flows : ScenesVerb {
    std::vector<std::string> scenes = {"F", "G"};
    int drives = 100;
    std::uint64_t first = 1;
  };
  auto flows = std::make_shared<Flows>();
  cli::Verb verb =
      bench.verb("flows", "Flows of people in a corridor; doors, corners, rows, overtaking, rushers");
  verb.option(
          "--scene", flows->scenes,
          "F1 to F5 (flows), G1 (door), G2 (blind corner), G3a and G3b (row with a gap and without), G4 (overtaking), G5a and "
          "G5b (rusher, child), separated by commas; F, G and G3 are all that begin so (all)")
      .separated_by_commas();
  verb.option("--drives", flows->drives, "Of each scene (100)").within(1, 100000);
  verb.option("--first", flows->first, "Seed of the first (1)");
  verb.flag("--check", flows->arguments.check, "Exit status 1 when a gate is missed");
  add_scene_options(verb, flows);
  verb.run([flows] {
    return bench_scenes(flow_sets(flows->scenes, flows->drives, flows->first), flows->arguments);
  });
}

}  // namespace bw
