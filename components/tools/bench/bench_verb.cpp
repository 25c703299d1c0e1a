#include <map>
#include <memory>

#include "components/tools/bench/bench.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/parameters/overrides.hpp"
#include "runtime/parameters/parameters.hpp"

namespace bw {
namespace {

void apply_overrides(LocalPlannerOptions& options, const std::vector<std::string>& set) {
  ConfigNode root;
  for (const std::string& text : set) apply_override(root, parse_override(text));
  read_into(options, root, "");
}

void add_teb(CLI::App* bench, int& status) {
  static const std::map<std::string, std::vector<BenchWeights>> kWeights = {
      {"file", {BenchWeights::file}},
      {"defaults", {BenchWeights::defaults}},
      {"both", {BenchWeights::file, BenchWeights::defaults}}};
  auto teb = std::make_shared<BenchTebArguments>();
  CLI::App* teb_verb =
      bench->add_subcommand("teb", "Open loop: a cold plan and warm cycles; times in process CPU ms");
  teb_verb->add_option("--scenes", teb->scenes, "Scene file")->required();
  teb_verb->add_option("--scene", teb->scene, "Only scenes whose name begins so");
  teb_verb->add_option("--planner", teb->planner, "Planner name");
  teb_verb->add_option("--repetitions", teb->repetitions, "Runs of every scene")
      ->check(CLI::Range(1, 100000));
  teb_verb
      ->add_option_function<std::string>(
          "--weights", [teb](const std::string& name) { teb->weights = kWeights.at(name); },
          "file (comparable costs), defaults or both")
      ->check(CLI::IsMember({"file", "defaults", "both"}));
  auto teb_set = std::make_shared<std::vector<std::string>>();
  teb_verb->add_option("--set", *teb_set, "Planner parameter, as teb.band.dt_ref=0.28; as often as needed")
      ->allow_extra_args(false);
  teb_verb->add_option("--json", teb->json, "Writes the figures and plans here");
  teb_verb->callback([teb, teb_set, &status] {
    teb->adjust = [teb_set](LocalPlannerOptions& options) { apply_overrides(options, *teb_set); };
    status = bench_teb(*teb);
  });
}

void add_crowd(CLI::App* bench, int& status) {
  auto crowd = std::make_shared<BenchCrowdArguments>();
  CLI::App* crowd_verb = bench->add_subcommand("crowd", "Closed loop among walkers that do not react");
  crowd_verb->add_option("--scenes", crowd->scenes, "Scene file; may be left out with --generate");
  crowd_verb
      ->add_option("--generate", crowd->generate, "This many scenes by the same rule instead of the file's")
      ->check(CLI::Range(1, 100000));
  crowd_verb->add_option("--first-seed", crowd->first_seed, "Seed of the first generated scene");
  crowd_verb->add_option("--scene", crowd->scene, "Only scenes whose name begins so");
  crowd_verb->add_option("--planner", crowd->planners, "Planner names, separated by commas")->delimiter(',');
  auto set = std::make_shared<std::vector<std::string>>();
  crowd_verb->add_option("--set", *set, "Planner parameter, as teb.band.weights.time=2; as often as needed")
      ->allow_extra_args(false);
  crowd_verb->add_option("--jobs", crowd->jobs, "Episodes at a time; above 1 in thread CPU ms")
      ->check(CLI::Range(1, 64));
  crowd_verb->add_option("--write-scenes", crowd->write_scenes, "Writes the scenes driven here");
  crowd_verb
      ->add_option_function<std::string>(
          "--weights",
          [crowd](const std::string& name) {
            crowd->weights = name == "file" ? BenchWeights::file : BenchWeights::defaults;
          },
          "file or defaults")
      ->check(CLI::IsMember({"file", "defaults"}));
  crowd_verb->add_option("--json", crowd->json, "Writes the figures here");
  crowd_verb->callback([crowd, set, &status] {
    crowd->adjust = [set](LocalPlannerOptions& options) { apply_overrides(options, *set); };
    status = bench_crowd(*crowd);
  });
}

CLI::App* add_bench(CLI::App& app, int& status) {
  CLI::App* bench =
      app.add_subcommand("bench", "A local planner on benchmark scenes, without DDS")->require_subcommand(1);
  add_teb(bench, status);
  add_crowd(bench, status);
  return bench;
}

}  // namespace

BW_VERB(measure, "bench", add_bench)

}  // namespace bw
