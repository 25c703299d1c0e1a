#include <map>
#include <memory>

#include "components/tools/bench/bench.hpp"
#include "components/tools/bench/bench_bag.hpp"
#include "components/tools/bench/bench_course.hpp"
#include "components/tools/bench/bench_crowdnav.hpp"
#include "components/tools/bench/bench_people.hpp"
#include "components/tools/bench/scaling.hpp"
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
  teb_verb->add_flag("--samples", teb->with_samples,
                     "Start, start speeds and plan of every cycle go into the JSON");
  teb_verb->callback([teb, teb_set, &status] {
    teb->adjust = [teb_set](LocalPlannerOptions& options) { apply_overrides(options, *teb_set); };
    status = bench_teb(*teb);
  });
}

void add_crowd(CLI::App* bench, int& status) {
  static const std::map<std::string, WalkersManner> kWalkers = {{"straight", WalkersManner::straight},
                                                                {"social", WalkersManner::social},
                                                                {"orca", WalkersManner::orca}};
  auto crowd = std::make_shared<BenchCrowdArguments>();
  CLI::App* crowd_verb = bench->add_subcommand("crowd", "Closed loop among walkers");
  crowd_verb->add_option("--scenes", crowd->scenes, "Scene file; may be left out with --generate");
  crowd_verb
      ->add_option("--generate", crowd->generate, "This many scenes by the same rule instead of the file's")
      ->check(CLI::Range(1, 100000));
  crowd_verb->add_option("--first-seed", crowd->first_seed, "Seed of the first generated scene");
  crowd_verb
      ->add_option(
          "--density", crowd->densities,
          "Generated crowds of so many persons per square metre (0.3, 0.5; several separated by commas) instead of 6, 10 "
          "or 14 persons")
      ->delimiter(',')
      ->check(CLI::Range(0.01, 0.8));
  crowd_verb
      ->add_option_function<std::vector<std::string>>(
          "--walkers",
          [crowd](const std::vector<std::string>& names) {
            crowd->walkers.clear();
            for (const std::string& name : names) crowd->walkers.push_back(kWalkers.at(name));
          },
          "straight (default: they react to nobody), social or orca (they see each other and the robot); several separated by commas")
      ->delimiter(',')
      ->check(CLI::IsMember({"straight", "social", "orca"}));
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
  crowd_verb->add_option("--against", crowd->against,
                         "The planner that the others are held against (the first)");
  crowd_verb->add_option(
      "--failures", crowd->failures,
      "Pictures of the first 30 drives that failed, and a page of them, go into this folder");
  crowd_verb->add_option("--json", crowd->json, "Writes the figures here");
  crowd_verb->add_flag("--samples", crowd->with_samples,
                       "Pose, command, applied velocity and walkers of every period go into the JSON");
  crowd_verb->callback([crowd, set, &status] {
    crowd->adjust = [set](LocalPlannerOptions& options) { apply_overrides(options, *set); };
    status = bench_crowd(*crowd);
  });
}

void add_crowdnav(CLI::App* bench, int& status) {
  auto crowdnav = std::make_shared<BenchCrowdNavArguments>();
  CLI::App* verb =
      bench->add_subcommand("crowdnav", "CrowdNav's circle and square: five people who avoid each other");
  verb->add_option_function<std::string>(
          "--scene",
          [crowdnav](const std::string& name) {
            crowdnav->crossing = name == "circle" ? CrowdNavCrossing::circle : CrowdNavCrossing::square;
          },
          "circle (default) or square")
      ->check(CLI::IsMember({"circle", "square"}));
  verb->add_flag("--visible", crowdnav->visible, "People see the robot and avoid it as one of them");
  verb->add_option("--first-case", crowdnav->first_case, "First of the 500 test cases (0)")
      ->check(CLI::Range(0, kCrowdNavCases - 1));
  verb->add_option("--cases", crowdnav->cases, "How many from it on (500)")
      ->check(CLI::Range(1, kCrowdNavCases));
  verb->add_option(
          "--planner", crowdnav->planners,
          "Planner names, separated by commas; orca_holonomic is CrowdNav's own, which moves any way")
      ->delimiter(',');
  verb->add_option("--safety-space", crowdnav->safety_space,
                   "By which orca_holonomic widens everybody [m] (0)")
      ->check(CLI::Range(0.0, 1.0));
  auto set = std::make_shared<std::vector<std::string>>();
  verb->add_option("--set", *set, "Planner parameter, as teb.band.weights.time=2; as often as needed")
      ->allow_extra_args(false);
  verb->add_option("--jobs", crowdnav->jobs, "Cases at a time; above 1 in thread CPU ms")
      ->check(CLI::Range(1, 64));
  verb->add_option("--json", crowdnav->json, "Writes the figures here");
  verb->add_flag("--samples", crowdnav->with_samples, "Robot and people of every step go into the JSON");
  verb->callback([crowdnav, set, &status] {
    crowdnav->adjust = [set](LocalPlannerOptions& options) { apply_overrides(options, *set); };
    status = bench_crowdnav(*crowdnav);
  });
}

void add_bag(CLI::App* bench, int& status) {
  auto bag = std::make_shared<BenchBagArguments>();
  CLI::App* verb = bench->add_subcommand("bag", "Recordings: written, opened, searched and read");
  verb->add_option("--folder", bag->folder, "Where bags are made, and deleted")
      ->check(CLI::ExistingDirectory);
  verb->add_option("--size", bag->size_gb, "Messages in the bag that is opened and searched [GB] (1)")
      ->check(CLI::Range(0.001, 1e9));
  verb->add_option("--compression", bag->compression,
                   "Of that bag: none (so large is the file then), lz4 or zstd")
      ->check(CLI::IsMember({"none", "lz4", "zstd"}));
  verb->add_option("--write", bag->write_gb, "Messages written in each compression [GB] (1)")
      ->check(CLI::Range(0.001, 1e9));
  verb->add_option("--read", bag->read, "Measures reading of this bag, and writes none");
  verb->add_option("--seeks", bag->seeks, "Random times to go to (100)")->check(CLI::Range(0, 100000));
  verb->add_option("--seed", bag->seed, "Of contents and times");
  verb->add_flag("--keep", bag->keep, "Leaves the large bag");
  verb->add_option("--json", bag->json, "Writes the figures here");
  verb->callback([bag, &status] { status = bench_bag(*bag); });
}

void add_course(CLI::App* bench, int& status) {
  auto course = std::make_shared<BenchCourseArguments>();
  CLI::App* verb = bench->add_subcommand(
      "course", "Whole robots through fields of cylinders, 10 m without a map; success, time and score");
  verb->add_option("--worlds", course->worlds, "Folder of worlds, a CSV x_m,y_m,radius_m each")
      ->check(CLI::ExistingDirectory);
  verb->add_option("--only", course->only, "Only worlds whose name begins so");
  verb->add_option("--generate", course->generate, "This many as hard as the given ones, from seeds")
      ->check(CLI::Range(1, 100000));
  verb->add_option("--first-seed", course->first_seed, "Seed of the first generated one");
  verb->add_option("--planner", course->planners, "Planner names, separated by commas")->delimiter(',');
  verb->add_option("--graph", course->graph, "Graph file (config/graphs/course.yaml)");
  verb->add_option("--set", course->set, "component.parameter=value, as often as needed")
      ->allow_extra_args(false);
  verb->add_option("--svg", course->svg, "Folder for a picture of each drive");
  verb->add_option("--json", course->json, "Writes the figures here");
  verb->callback([course, &status] { status = bench_course(*course); });
}

void add_people(CLI::App* bench, int& status) {
  auto people = std::make_shared<BenchPeopleArguments>();
  CLI::App* verb =
      bench->add_subcommand("people", "People tracked again in a recording, and scored against labels");
  verb->add_option("BAG", people->bag,
                   "File or folder: a laser's scans, odometry or transforms, perhaps a map")
      ->required();
  verb->add_option("--labels", people->labels, "CSV of who was where; several are several stretches");
  verb->add_flag("--truth,!--no-truth", people->with_truth,
                 "Without labels: score by the simulated world's truth, if the bag has it (default)");
  verb->add_option("--range", people->range, "By that truth, people so far from the laser count [m] (6)")
      ->check(CLI::Range(0.5, 100.0));
  verb->add_option("--graph", people->graph, "Graph file with the component; without, one with its defaults");
  verb->add_option("--component", people->component,
                   "Its name in the graph, where several are of type people");
  verb->add_option("--set", people->set, "people.tracker.x=value, as often as needed")
      ->allow_extra_args(false);
  verb->add_option("--scan", people->scan, "Topic of the scans, if not the component's and not the only one");
  verb->add_option("--odom", people->odom, "Topic of the odometry, likewise");
  verb->add_flag("--standing", people->is_standing, "The robot does not move: no odometry is needed");
  verb->add_option("--label-deviation", people->scoring.label_deviation,
                   "Of the places in the labels, added to predicted ellipses [m] (0)")
      ->check(CLI::Range(0.0, 5.0));
  verb->add_flag("--errors", people->show_errors, "Prints every miss, false track and other identity");
  verb->add_option("--json", people->json, "Writes the figures, errors and tracks here");
  verb->add_option("--svg", people->svg, "Writes a picture of all tracks here");
  verb->callback([people, &status] { status = bench_people(*people); });
}

void add_scaling(CLI::App* bench, int& status) {
  auto scaling = std::make_shared<BenchScalingArguments>();
  CLI::App* verb = bench->add_subcommand("scaling", "Planning among more and more obstacles; process CPU ms");
  verb->add_option("--planner", scaling->planners, "Planner names, separated by commas")->delimiter(',');
  verb->add_option("--repetitions", scaling->repetitions, "Scenes of every number")
      ->check(CLI::Range(1, 10000));
  verb->add_option("--drives", scaling->drives, "Drives through every corridor of points")
      ->check(CLI::Range(0, 10000));
  verb->add_option("--json", scaling->json, "Writes the figures here");
  verb->callback([scaling, &status] { status = bench_scaling(*scaling); });
}

CLI::App* add_bench(CLI::App& app, int& status) {
  CLI::App* bench =
      app.add_subcommand("bench",
                         "Local planners on benchmark scenes, recordings, and people tracked in them")
          ->require_subcommand(1);
  add_teb(bench, status);
  add_crowd(bench, status);
  add_crowdnav(bench, status);
  add_scaling(bench, status);
  add_bag(bench, status);
  add_people(bench, status);
  add_course(bench, status);
  return bench;
}

}  // namespace

BW_VERB(measure, "bench", add_bench)

}  // namespace bw
