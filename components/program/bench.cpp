#include "components/program/bench.hpp"

#include <map>
#include <memory>

#include "components/local_planner/bench/bench.hpp"

namespace bw {

void add_bench(CLI::App& app, int& status) {
  static const std::map<std::string, std::vector<BenchWeights>> kWeights = {
      {"file", {BenchWeights::file}},
      {"defaults", {BenchWeights::defaults}},
      {"both", {BenchWeights::file, BenchWeights::defaults}}};
  CLI::App* bench =
      app.add_subcommand("bench", "A local planner on benchmark scenes, without DDS")->require_subcommand(1);

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
  teb_verb->add_option("--json", teb->json, "Writes the figures and plans here");
  teb_verb->callback([teb, &status] { status = bench_teb(*teb); });

  auto crowd = std::make_shared<BenchCrowdArguments>();
  CLI::App* crowd_verb = bench->add_subcommand("crowd", "Closed loop among walkers that do not react");
  crowd_verb->add_option("--scenes", crowd->scenes, "Scene file")->required();
  crowd_verb->add_option("--scene", crowd->scene, "Only scenes whose name begins so");
  crowd_verb->add_option("--planner", crowd->planner, "Planner name");
  crowd_verb
      ->add_option_function<std::string>(
          "--weights",
          [crowd](const std::string& name) {
            crowd->weights = name == "file" ? BenchWeights::file : BenchWeights::defaults;
          },
          "file or defaults")
      ->check(CLI::IsMember({"file", "defaults"}));
  crowd_verb->add_option("--json", crowd->json, "Writes the figures here");
  crowd_verb->callback([crowd, &status] { status = bench_crowd(*crowd); });
}

}  // namespace bw
