// bandwagon reproduce navigation: the hallway in lock-step by the source's robots, each through its emulated base and laser.
#include <iostream>

#include <fmt/format.h>

#include "components/tools/experiments/drive_figure.hpp"
#include "components/tools/experiments/navigation_report.hpp"
#include "components/tools/experiments/project_file.hpp"
#include "components/tools/experiments/reproduce_drives.hpp"
#include "components/tools/experiments/reproduce_report.hpp"
#include "runtime/graph/graph.hpp"

namespace bw {
namespace {

constexpr std::int64_t kQuickSeeds = 2;

Graph navigation_graph(const NavigationPair& pair, bool simulated_drivers) {
  std::vector<std::string> set = {
      "robot=" + std::filesystem::absolute(project_file("config/robots/" + pair.robot_file)).string(),
      "local_planner.algorithm=" + pair.planner};
  if (simulated_drivers) {
    set.insert(set.end(), {"robot.base.driver=simulated", "robot.laser.driver=none"});
  } else {
    set.emplace_back("emulate=true");
  }
  return load_graph(project_file("config/graphs/hallway.yaml"), set);
}

std::string title_of(const NavigationPair& pair, std::int64_t seed, bool simulated_drivers) {
  return fmt::format("{} {}{} seed {}", pair.robot, pair.planner,
                     simulated_drivers ? ", simulated drivers," : "", seed);
}

/// Of each pair the first seed.
std::string figures_of(const NavigationResults& results, const std::vector<DriveJob>& jobs) {
  std::string html;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const NavigationDrive& drive = results.drives[i];
    if (drive.seed != 1) continue;
    const NavigationPair& pair = navigation_pairs()[drive.pair];
    if (const std::optional<RunRecording> course = course_of(jobs[i]))
      html +=
          drive_figure(*course, fmt::format("{}, {}, seed 1", pair.robot, pair.planner),
                       drive.succeeded() ? "It reaches its goal without a contact." : "It fails: see below.");
  }
  return html;
}

}  // namespace

bool reproduce_navigation(const ReproduceArguments& arguments) {
  NavigationResults results{.emulated = !arguments.simulated_drivers};
  std::vector<DriveJob> jobs;
  const std::vector<NavigationPair>& pairs = navigation_pairs();
  for (std::size_t pair = 0; pair < pairs.size(); ++pair) {
    for (std::int64_t seed = 1; seed <= (arguments.quick ? kQuickSeeds : kNavigationSeeds); ++seed) {
      jobs.push_back({.title = title_of(pairs[pair], seed, arguments.simulated_drivers),
                      .seed = seed,
                      .graph = [&pairs, pair, simulated = arguments.simulated_drivers] {
                        return navigation_graph(pairs[pair], simulated);
                      }});
      results.drives.push_back({.pair = pair, .seed = seed});
    }
  }
  const std::vector<DrivenJob> driven = drive_all(jobs, arguments);
  if (!arguments.shard.is_all()) return true;
  for (std::size_t i = 0; i < driven.size(); ++i) {
    NavigationDrive& drive = results.drives[i];
    drive = navigation_drive(drive.pair, drive.seed, driven[i].card);
    drive.page = driven[i].page;
  }
  const std::vector<Criterion> criteria = navigation_criteria(results);
  fmt::print("{}{}", navigation_table(results), criteria_text(criteria));
  return write_report({.subject = "navigation",
                       .judged = "every drive reaches its goal without a contact; no number is published",
                       .criteria = criteria,
                       .published = published_values(results),
                       .results = navigation_json(results),
                       .page = navigation_page(results, figures_of(results, jobs))},
                      arguments);
}

}  // namespace bw
