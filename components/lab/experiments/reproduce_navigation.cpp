// bandwagon reproduce navigation: the hallway in lock-step by the source's robots, each through its emulated
// base and laser.
#include <algorithm>
#include <iostream>
#include <numeric>

#include <fmt/format.h>

#include "components/lab/evaluate/suite.hpp"
#include "components/lab/experiments/drive_chart.hpp"
#include "components/lab/experiments/navigation_report.hpp"
#include "components/lab/experiments/reproduce_drives.hpp"
#include "components/lab/experiments/reproduce_report.hpp"
#include "runtime/graph/graph.hpp"
#include "runtime/parameters/overrides.hpp"

namespace bw {
namespace {

constexpr std::int64_t kQuickNavigationSeeds = 2;

Graph navigation_graph(const Suite& suite, std::size_t episode, const NavigationPair& pair,
                       bool simulated_drivers) {
  Graph graph = suite.graph_of(episode);
  const auto set = [&graph](const std::string& text) { apply_override(graph, parse_override(text)); };
  set("robot=" + pair.robot_file);
  if (simulated_drivers) {
    set("robot.base.driver=simulated");
    set("robot.laser.driver=none");
  } else {
    set("emulate=true");
  }
  set("local_planner.algorithm=" + pair.planner);
  if (pair.as_published) set("local_planner.dwa.profile=scales");
  return graph;
}

/// Of each pair the first seed.
std::vector<report::Figure> figures_of(const NavigationResults& results, const std::vector<DriveJob>& jobs) {
  std::vector<report::Figure> figures;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const NavigationDrive& drive = results.drives[i];
    if (drive.seed != 1 || drive.hallway != kNavigationHallway) continue;
    const NavigationPair& pair = navigation_pairs()[drive.pair];
    if (const std::optional<RunRecording> course = course_of(jobs[i]))
      figures.push_back(drive_figure(
          *course,
          fmt::format("{}, {}{}, seed 1", pair.robot, pair.planner, pair.as_published ? " as published" : ""),
          drive.succeeded() ? "It reaches its goal without a contact." : "It fails: see below."));
  }
  return figures;
}

}  // namespace

bool reproduce_navigation(const ReproduceArguments& arguments) {
  const bool simulated = arguments.simulated_drivers;
  const Suite suite = load_suite("hallway");
  NavigationResults results{.emulated = !simulated};
  std::vector<DriveJob> jobs;
  std::vector<std::size_t> episodes(suite.options.episodes.size());
  std::iota(episodes.begin(), episodes.end(), std::size_t{0});
  // What is judged first: of a run that is interrupted it is there.
  std::ranges::stable_partition(episodes, [&suite](std::size_t episode) {
    return suite.options.episodes[episode].name == kNavigationHallway;
  });
  for (const std::size_t episode : episodes) {
    const std::string& hallway = suite.options.episodes[episode].name;
    for (std::size_t i = 0; i < navigation_pairs().size(); ++i) {
      const NavigationPair& pair = navigation_pairs()[i];
      for (std::int64_t seed = 1; seed <= (arguments.quick ? kQuickNavigationSeeds : kNavigationSeeds);
           ++seed) {
        jobs.push_back(
            {.title = fmt::format("{} {}{}, hallway {}{} seed {}", pair.robot, pair.planner,
                                  pair.as_published ? " as published" : "", hallway,
                                  simulated ? ", simulated drivers," : "", seed),
             .seed = seed,
             .time_limit = suite.options.time_limit,
             .graph = [=, &suite, &pair] { return navigation_graph(suite, episode, pair, simulated); }});
        results.drives.push_back({.pair = i, .hallway = hallway, .seed = seed});
      }
    }
  }
  const std::vector<DrivenJob> driven = drive_all(jobs, arguments);
  if (!arguments.shard.is_all()) return true;
  for (std::size_t i = 0; i < driven.size(); ++i) {
    NavigationDrive& drive = results.drives[i];
    drive = navigation_drive(drive.pair, drive.hallway, drive.seed, driven[i].card);
    drive.page = driven[i].page;
  }
  const std::vector<Criterion> criteria = navigation_criteria(results, kNavigationHallway);
  fmt::print("{}{}", navigation_table(results), criteria_text(criteria));
  return write_report(
      {.subject = "navigation",
       .judged =
           "every drive through the hallway with three walkers reaches its goal without a contact; no number is published",
       .criteria = criteria,
       .published = published_values(results),
       .results = navigation_json(results),
       .page = navigation_page(results, figures_of(results, jobs)),
       .other_readings = {{"six walkers", navigation_criteria(results, "full")}}},
      arguments);
}

}  // namespace bw
