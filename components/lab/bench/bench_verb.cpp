#include <algorithm>
#include <map>
#include <memory>
#include <stdexcept>

#include "components/lab/bench/bench.hpp"
#include "components/lab/bench/bench_bag.hpp"
#include "components/lab/bench/bench_common.hpp"
#include "components/lab/bench/bench_course.hpp"
#include "components/lab/bench/bench_crowdnav.hpp"
#include "components/lab/bench/bench_people.hpp"
#include "components/lab/bench/explore/bench_explore.hpp"
#include "components/lab/bench/planner_overrides.hpp"
#include "components/lab/bench/scaling.hpp"
#include "components/lab/bench/scenes_verb.hpp"
#include "components/lab/bench/slam/bench_kidnaps.hpp"
#include "components/lab/bench/slam/bench_relations.hpp"
#include "components/lab/bench/slam/bench_rounds.hpp"
#include "components/lab/bench/slam/bench_slam.hpp"
#include "components/lab/report/report_page.hpp"
#include "components/lab/shards/provenance.hpp"
#include "runtime/cli/verb.hpp"

namespace bw {
namespace {

void add_teb(cli::Verb bench) {
  static const std::map<std::string, std::vector<BenchWeights>> kWeights = {
      {"file", {BenchWeights::file}},
      {"defaults", {BenchWeights::defaults}},
      {"both", {BenchWeights::file, BenchWeights::defaults}}};
  auto teb = std::make_shared<BenchTebArguments>();
  cli::Verb teb_verb = bench.verb("teb", "Open loop: a cold plan and warm cycles; times in process CPU ms");
  teb_verb.option("--scenes", teb->scenes, "Scene file").required();
  teb_verb.option("--scene", teb->scene, "Only scenes whose name begins so");
  teb_verb.option("--planner", teb->planner, "Planner name");
  teb_verb.option("--repetitions", teb->repetitions, "Runs of every scene").within(1, 100000);
  teb_verb
      .option_function(
          "--weights", [teb](const std::string& name) { teb->weights = kWeights.at(name); },
          "file (comparable costs), defaults or both")
      .one_of({"file", "defaults", "both"});
  auto teb_set = std::make_shared<std::vector<std::string>>();
  teb_verb.option("--set", *teb_set, "Planner parameter, as teb.band.dt_ref=0.28; as often as needed")
      .one_each_time();
  teb_verb.option("--json", teb->json, "Writes the figures and plans here");
  teb_verb.flag("--samples", teb->with_samples,
                "Start, start speeds and plan of every cycle go into the JSON");
  teb_verb.run([teb, teb_set] {
    teb->adjust = [teb_set](PlannerOptions& options) { apply_overrides(options, *teb_set); };
    return bench_teb(*teb);
  });
}

void add_crowd(cli::Verb bench) {
  static const std::map<std::string, WalkersManner> kWalkers = {{"straight", WalkersManner::straight},
                                                                {"social", WalkersManner::social},
                                                                {"orca", WalkersManner::orca}};
  auto crowd = std::make_shared<BenchCrowdArguments>();
  cli::Verb crowd_verb = bench.verb("crowd", "Closed loop among walkers");
  crowd_verb.option("--scenes", crowd->scenes, "Scene file; may be left out with --generate");
  crowd_verb.option("--generate", crowd->generate, "This many scenes by the same rule instead of the file's")
      .within(1, 100000);
  crowd_verb.option("--first-seed", crowd->first_seed, "Seed of the first generated scene");
  crowd_verb
      .option(
          "--density", crowd->densities,
          "Generated crowds of so many persons per square metre (0.3, 0.5; several separated by commas) instead of 6, 10 "
          "or 14 persons")
      .separated_by_commas()
      .within(0.01, 0.8);
  crowd_verb
      .list_function(
          "--walkers",
          [crowd](const std::vector<std::string>& names) {
            crowd->walkers.clear();
            for (const std::string& name : names) crowd->walkers.push_back(kWalkers.at(name));
          },
          "straight (default: they react to nobody), social or orca (they see each other and the robot); several separated by commas")
      .separated_by_commas()
      .one_of({"straight", "social", "orca"});
  crowd_verb.option("--scene", crowd->scene, "Only scenes whose name begins so");
  crowd_verb.option("--planner", crowd->planners, "Planner names, separated by commas").separated_by_commas();
  auto set = std::make_shared<std::vector<std::string>>();
  crowd_verb.option("--set", *set, "Planner parameter, as teb.band.weights.time=2; as often as needed")
      .one_each_time();
  crowd_verb.option("--jobs", crowd->jobs, "Episodes at a time; above 1 in thread CPU ms").within(1, 64);
  crowd_verb.option("--write-scenes", crowd->write_scenes, "Writes the scenes driven here");
  crowd_verb
      .option_function(
          "--weights",
          [crowd](const std::string& name) {
            crowd->weights = name == "file" ? BenchWeights::file : BenchWeights::defaults;
          },
          "file or defaults")
      .one_of({"file", "defaults"});
  crowd_verb.option("--against", crowd->against, "The planner that the others are held against (the first)");
  crowd_verb.option(
      "--failures", crowd->failures,
      "index.html in this folder shows the first 30 drives that failed, in a list and a picture each");
  crowd_verb.option("--json", crowd->json, "Writes the figures here");
  crowd_verb.flag("--samples", crowd->with_samples,
                  "Pose, command, applied velocity and walkers of every period go into the JSON");
  crowd_verb.run([crowd, set] {
    crowd->adjust = [set](PlannerOptions& options) { apply_overrides(options, *set); };
    if (!crowd->failures.empty()) require_report_page("--failures " + crowd->failures);
    crowd->write_page = write_report_page;
    return bench_crowd(*crowd);
  });
}

void add_crowdnav(cli::Verb bench) {
  auto crowdnav = std::make_shared<BenchCrowdNavArguments>();
  cli::Verb verb = bench.verb("crowdnav", "CrowdNav's circle and square, CrowdNav++'s crowds of twenty");
  verb.option_function(
          "--scene",
          [crowdnav](const std::string& name) {
            for (const CrowdNavCrossing crossing : kCrowdNavCrossings)
              if (name == to_text(crossing)) crowdnav->crossing = crossing;
          },
          "circle (default), square, crowd or mixed_crowd")
      .one_of({"circle", "square", "crowd", "mixed_crowd"});
  verb.flag("--visible", crowdnav->conditions.visible, "People see the robot and avoid it as one of them");
  verb.flag("--sampled", crowdnav->conditions.sampled,
            "Contacts between steps of 0.25 s are none, as CrowdNav++ counts");
  verb.option("--first-case", crowdnav->first_case, "First of the 500 test cases (0)")
      .within(0, kCrowdNavCases - 1);
  verb.option("--cases", crowdnav->cases, "How many from it on (500)").within(1, kCrowdNavCases);
  verb.option(
          "--planner", crowdnav->planners,
          "Planner names, separated by commas; orca_holonomic, orca_published and social_force_holonomic move any way")
      .separated_by_commas();
  verb.option("--safety-space", crowdnav->safety_space,
              "By which orca_holonomic widens everybody [m] (as people do: 0, in crowds 0.15)")
      .within(0.0, 1.0);
  auto set = std::make_shared<std::vector<std::string>>();
  verb.option("--set", *set, "Planner parameter, as teb.band.weights.time=2; as often as needed")
      .one_each_time();
  verb.option("--jobs", crowdnav->jobs, "Cases at a time; above 1 in thread CPU ms").within(1, 64);
  verb.option("--json", crowdnav->json, "Writes the figures here");
  verb.flag("--samples", crowdnav->with_samples, "Robot and people of every step go into the JSON");
  verb.run([crowdnav, set] {
    crowdnav->adjust = [set](PlannerOptions& options) { apply_overrides(options, *set); };
    return bench_crowdnav(*crowdnav);
  });
}

void add_bag(cli::Verb bench) {
  auto bag = std::make_shared<BenchBagArguments>();
  cli::Verb verb = bench.verb("bag", "Recordings: written, opened, searched and read");
  verb.option("--folder", bag->folder, "Where bags are made, and deleted").existing_folder();
  verb.option("--size", bag->size_gb, "Messages in the bag that is opened and searched [GB] (1)")
      .within(0.001, 1e9);
  verb.option("--compression", bag->compression, "Of that bag: none (so large is the file then), lz4 or zstd")
      .one_of({"none", "lz4", "zstd"});
  verb.option("--write", bag->write_gb, "Messages written in each compression [GB] (1)").within(0.001, 1e9);
  verb.option("--read", bag->read, "Measures reading of this bag, and writes none");
  verb.option("--seeks", bag->seeks, "Random times to go to (100)").within(0, 100000);
  verb.option("--seed", bag->seed, "Of contents and times");
  verb.flag("--keep", bag->keep, "Leaves the large bag");
  verb.option("--json", bag->json, "Writes the figures here");
  verb.run([bag] { return bench_bag(*bag); });
}

void add_course(cli::Verb bench) {
  auto course = std::make_shared<BenchCourseArguments>();
  cli::Verb verb = bench.verb(
      "course", "Whole robots through fields of cylinders, 10 m without a map; success, time and score");
  verb.option("--worlds", course->worlds, "Folder of worlds, a CSV x_m,y_m,radius_m each").existing_folder();
  verb.option("--only", course->only, "Only worlds whose name begins so");
  verb.option("--generate", course->generate, "This many as hard as the given ones, from seeds")
      .within(1, 100000);
  verb.option("--first-seed", course->first_seed, "Seed of the first generated one");
  verb.option("--planner", course->planners, "Planner names, separated by commas").separated_by_commas();
  verb.option("--graph", course->graph, "Graph file, or the name of one (course)");
  verb.option("--set", course->set, "component.parameter=value, as often as needed").one_each_time();
  verb.option("--svg", course->svg, "Folder for a picture of each drive");
  verb.option("--json", course->json, "Writes the figures here");
  verb.run([course] { return bench_course(*course); });
}

void add_people(cli::Verb bench) {
  auto people = std::make_shared<BenchPeopleArguments>();
  cli::Verb verb = bench.verb("people", "People tracked again in a recording, and scored against labels");
  verb.option("BAG", people->bag, "File or folder: a laser's scans, odometry or transforms, perhaps a map")
      .required();
  verb.option("--labels", people->labels, "CSV of who was where; several are several stretches");
  verb.flag("--truth,!--no-truth", people->with_truth,
            "Without labels: score by the simulated world's truth, if the bag has it (default)");
  verb.option("--range", people->range, "By that truth, people so far from the laser count [m] (6)")
      .within(0.5, 100.0);
  verb.option("--graph", people->graph, "Graph file with the component; without, one with its defaults");
  verb.option("--component", people->component, "Its name in the graph, where several are of type people");
  verb.option("--set", people->set, "people.tracker.x=value, as often as needed").one_each_time();
  verb.option("--scan", people->scan, "Topic of the scans, if not the component's and not the only one");
  verb.option("--odom", people->odom, "Topic of the odometry, likewise");
  verb.flag("--standing", people->is_standing, "The robot does not move: no odometry is needed");
  verb.option("--label-deviation", people->scoring.label_deviation,
              "Of the places in the labels, added to predicted ellipses [m] (0)")
      .within(0.0, 5.0);
  verb.flag("--errors", people->show_errors, "Prints every miss, false track and other identity");
  verb.option("--json", people->json, "Writes the figures, errors and tracks here");
  verb.option("--page", people->page, "Shows all tracks here: one HTML file");
  verb.option_function(
      "--svg",
      [](const std::string&) { throw std::runtime_error("--svg: tracks are shown by --page FILE.html"); },
      "It is --page FILE.html");
  verb.run([people] { return bench_people(*people); });
}

void add_scaling(cli::Verb bench) {
  auto scaling = std::make_shared<BenchScalingArguments>();
  cli::Verb verb = bench.verb("scaling", "Planning among more and more obstacles; process CPU ms");
  verb.option("--planner", scaling->planners, "Planner names, separated by commas").separated_by_commas();
  verb.option("--repetitions", scaling->repetitions, "Scenes of every number").within(1, 10000);
  verb.option("--drives", scaling->drives, "Drives through every corridor of points").within(0, 10000);
  verb.option("--json", scaling->json, "Writes the figures here");
  verb.run([scaling] { return bench_scaling(*scaling); });
}

void add_relations(cli::Verb bench) {
  auto relations = std::make_shared<BenchRelationsArguments>();
  cli::Verb verb = bench.verb(
      "relations", "SLAM on a recorded drive, scored by relations between poses (Kuemmerle et al. 2009)");
  verb.option("BAG", relations->bag, "File or folder with scans and odometry; with --columns a table")
      .required();
  verb.option("RELATIONS", relations->relations,
              "Lines t1 t2 x y z roll pitch yaw; may be compressed by gzip")
      .required();
  verb.option("--columns", relations->columns,
              "Reads a table by this columns file (config/imports/README.md)");
  verb.option("--odometry-scale", relations->odometry_scale, "Steps of the odometry times this (1)")
      .within(0.1, 10.0);
  verb.option("--every", relations->every, "Takes one of so many scans (1)").within(1, 1000);
  verb.option("--view", relations->view, "Takes beams within so many degrees, half on either side")
      .within(1.0, 360.0);
  verb.option("--set", relations->set, "slam.parameter=value, as often as needed").one_each_time();
  verb.option("--json", relations->json, "Writes the figures here");
  verb.run([relations] { return bench_relations(*relations); });
}

void add_slam(cli::Verb bench) {
  auto slam = std::make_shared<BenchSlamArguments>();
  cli::Verb verb = bench.verb("slam", "SLAM in simulated buildings, scored by the exact truth");
  verb.option_function(
          "--kind",
          [slam](const std::string& name) {
            slam->kinds.clear();
            for (const buildings::BuildingKind kind : buildings::kBuildingKinds) {
              if (name == "all" || name == buildings::to_text(kind)) slam->kinds.push_back(kind);
            }
            if (name == "campus") slam->kinds = {buildings::BuildingKind::campus};
          },
          "office (default), corridors, loop, pillars, warehouse, all of these, or campus")
      .one_of({"office", "corridors", "loop", "pillars", "warehouse", "all", "campus"});
  verb.option("--seeds", slam->seeds, "Buildings of each kind (1)").within(1, 10000);
  verb.option("--first", slam->first, "Seed of the first (1)");
  verb.option("--walkers", slam->drive.walkers, "People who walk about (0)").within(0, 1000);
  verb.option_function(
          "--base",
          [slam](const std::string& name) {
            for (const auto base : {buildings::DrivenBase::kobuki, buildings::DrivenBase::qbot2e,
                                    buildings::DrivenBase::eddie}) {
              if (name == buildings::to_text(base)) slam->drive.base = base;
            }
          },
          "kobuki (default), qbot2e or eddie: wheels that err as the emulated ones do")
      .one_of({"kobuki", "qbot2e", "eddie"});
  verb.option(
          "--rounds", slam->rounds,
          "Drives the route of an office so often, with its furniture elsewhere each time: is the map bounded?")
      .within(1, 1000);
  verb.option("--kidnaps", slam->kidnaps,
              "After the drive it is carried to another place so often: when does it know where it is?")
      .within(1, 10000);
  verb.flag("--calibrated", slam->calibrated, "Wheels as `bandwagon calibrate` may leave them");
  verb.option("--set", slam->set, "slam.parameter=value, as often as needed").one_each_time();
  verb.option("--json", slam->json, "Writes the figures here");
  verb.run([slam] {
    if (slam->kidnaps > 0) return bench_kidnaps(*slam);
    return slam->rounds > 0 ? bench_rounds(*slam) : bench_slam(*slam);
  });
}

void add_explore(cli::Verb bench) {
  auto explore = std::make_shared<BenchExploreArguments>();
  cli::Verb verb = bench.verb("explore", "Simulated buildings explored by a whole robot in lock-step");
  verb.list_function(
          "--kind",
          [explore](const std::vector<std::string>& names) {
            explore->kinds.clear();
            for (const buildings::BuildingKind kind : buildings::kBuildingKinds)
              if (std::ranges::find(names, buildings::to_text(kind)) != names.end())
                explore->kinds.push_back(kind);
          },
          "office (default), corridors, loop, pillars, warehouse; several separated by commas")
      .separated_by_commas()
      .one_of({"office", "corridors", "loop", "pillars", "warehouse"});
  verb.option("--map", explore->map, "A place of your own instead: map_server's file").existing_file();
  verb.option("--start", explore->start, "X,Y in that map [m] (0,0)").separated_by_commas();
  verb.option("--seeds", explore->seeds, "Buildings of each kind, drives in a map (1)").within(1, 10000);
  verb.option("--first", explore->first, "Seed of the first (1)");
  verb.flag("--ideal", explore->ideal,
            "The map is right at once, ways are driven exactly, and nothing is simulated");
  verb.option("--robot", explore->drive.robot, "Robot file, or the name of one (kobuki)");
  verb.option("--longest", explore->drive.longest, "A drive ends then [s] (3600)").within(1.0, 1e5);
  verb.option("--set", explore->drive.set, "component.parameter=value, as often as needed").one_each_time();
  verb.option("--maps", explore->maps, "Folder for the map of each drive");
  verb.option("--json", explore->json, "Writes the figures here");
  verb.run([explore] { return bench_explore(*explore); });
}

void add_bench(cli::Verb bench) {
  tell_provenance([] {
    static const nlohmann::ordered_json kCitation = citation();
    return kCitation;
  });
  add_teb(bench);
  add_crowd(bench);
  add_crowdnav(bench);
  add_corridor(bench);
  add_dynabarn(bench);
  add_flows(bench);
  add_scaling(bench);
  add_bag(bench);
  add_people(bench);
  add_course(bench);
  add_relations(bench);
  add_slam(bench);
  add_explore(bench);
}

}  // namespace

BW_VERB(measure, "bench", "Planners on benchmark scenes; recordings: speed, people tracked in them, SLAM",
        add_bench)

}  // namespace bw
