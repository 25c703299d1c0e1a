// bandwagon reproduce pteb|eteb: E5 in process, then E6 as drives of the hallway suite, by ideal senses and
// by own.
#include <algorithm>
#include <iostream>
#include <stdexcept>

#include <fmt/format.h>

#include "components/lab/evaluate/suite.hpp"
#include "components/lab/experiments/anticipation_report.hpp"
#include "components/lab/experiments/kept_crossing.hpp"
#include "components/lab/experiments/published_values.hpp"
#include "components/lab/experiments/reproduce_drives.hpp"
#include "components/lab/experiments/reproduce_report.hpp"
#include "components/program/drive.hpp"
#include "runtime/build_identity.hpp"
#include "runtime/cli/signals.hpp"

namespace bw {
namespace {

constexpr int kQuickRuns = 5;
constexpr std::int64_t kQuickAnticipationSeeds = 2;
constexpr std::int64_t kOwnSensesSeeds = 10;  // half of those by ideal senses: reported, not judged

/// Pieces are counted through both geometries; a shard drives its own and returns too little.
std::vector<CrossingResult> drive_crossing(const std::vector<CrossingEntry>& entries,
                                           const CrossingGeometry& geometry, const std::string& where,
                                           const ReproduceArguments& arguments) {
  const Kept kept(arguments.out / "kept");
  const int runs = arguments.quick ? kQuickRuns : kCrossingRuns;
  std::vector<CrossingResult> results;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (!arguments.shard.has(i)) continue;
    std::cerr << fmt::format("people crossing, {}, {}: {} runs\n", where, entries[i].label, runs);
    results.push_back(kept_crossing(kept, file_name_of("crossing " + where + " " + entries[i].label),
                                    build_id() + cpu_type(), entries[i], geometry, runs));
    if (cli::interrupted()) throw std::runtime_error("interrupted; the same command goes on from here");
  }
  return results;
}

struct HallwayJob {
  CrossingEntry entry;
  bool own_senses = false;
  bool people_react = true;
  std::size_t episode = 0;
  std::int64_t seed = 1;
};

Graph hallway_graph(const Suite& suite, const HallwayJob& job) {
  Graph graph = suite.graph_of(job.episode);
  const auto set = [&graph](const std::string& text) { apply_override(graph, parse_override(text)); };
  const ComponentNode* planner = find_type(graph, "local_planner", "");
  if (planner == nullptr) throw std::runtime_error(suite.graph.string() + ": has no local_planner");
  const std::string name = planner->name;
  set(name + ".algorithm=" + job.entry.planner);
  for (const std::string& text : job.entry.set) set(name + "." + text);
  if (!job.own_senses) {  // planners are compared, not what they are told
    for (const char* exact :
         {"localization.enabled=false", "ideal_localization.enabled=true", "people.enabled=false",
          "ideal_people.enabled=true", "local_costmap.enabled=false", "obstacles.enabled=true",
          "world.drive={}", "world.imu={}"}) {
      set(exact);
    }
  }
  set(std::string("world.people_react=") + (job.people_react ? "true" : "false"));
  return graph;
}

/// Quick: of drives by own senses one a planner, full and among people who react.
std::vector<HallwayJob> hallway_jobs(const Suite& suite, const std::vector<CrossingEntry>& entries,
                                     bool own_senses, bool quick) {
  const SeedRange& seeds = suite.options.seeds;
  std::int64_t last_seed = own_senses ? std::min(seeds.last, seeds.first + kOwnSensesSeeds - 1) : seeds.last;
  if (quick) last_seed = seeds.first + (own_senses ? 1 : kQuickAnticipationSeeds) - 1;
  std::vector<HallwayJob> jobs;
  for (const bool people_react : {true, false}) {
    for (std::size_t episode = 0; episode < suite.options.episodes.size(); ++episode) {
      const bool is_main = people_react && suite.options.episodes[episode].name == "full";
      if (quick && own_senses && !is_main) continue;
      for (const CrossingEntry& entry : entries) {
        for (std::int64_t seed = seeds.first; seed <= last_seed; ++seed)
          jobs.push_back({entry, own_senses, people_react, episode, seed});
      }
    }
  }
  return jobs;
}

std::string title_of(const Suite& suite, const HallwayJob& job) {
  return fmt::format("hallway {}, {} senses, people {}, {} seed {}", suite.options.episodes[job.episode].name,
                     job.own_senses ? "own" : "ideal", job.people_react ? "react" : "do not react",
                     job.entry.label, job.seed);
}

/// By ideal senses all `entries`, then by its own the planners' defaults.
std::vector<HallwayDrive> drive_hallway(const std::vector<CrossingEntry>& entries,
                                        const std::vector<CrossingEntry>& defaults,
                                        const ReproduceArguments& arguments) {
  const Suite suite = load_suite("hallway");
  std::vector<HallwayJob> jobs = hallway_jobs(suite, entries, false, arguments.quick);
  for (HallwayJob& job : hallway_jobs(suite, defaults, true, arguments.quick)) jobs.push_back(std::move(job));
  std::vector<DriveJob> drives;
  for (const HallwayJob& job : jobs)
    drives.push_back({.title = title_of(suite, job),
                      .seed = job.seed,
                      .time_limit = suite.options.time_limit,
                      .graph = [&suite, job] { return hallway_graph(suite, job); }});
  std::vector<HallwayDrive> rows;
  for (DrivenJob& driven : drive_all(drives, arguments)) {
    const HallwayJob& job = jobs[rows.size()];
    rows.push_back(hallway_drive(job.entry.label, suite.options.episodes[job.episode].name, job.people_react,
                                 job.seed, driven.card));
    rows.back().own_senses = job.own_senses;
    rows.back().course = std::move(driven.course);
    rows.back().page = std::move(driven.page);
  }
  return rows;
}

bool reproduce(const std::string& subject, const ReproduceArguments& arguments) {
  const bool with_eteb = subject == "eteb";
  const std::vector<CrossingEntry> defaults = default_entries(with_eteb);
  std::vector<CrossingEntry> all = defaults;
  for (CrossingEntry& entry : published_entries(with_eteb)) all.push_back(std::move(entry));

  AnticipationResults results{.subject = subject};
  results.crossing = drive_crossing(all, results.geometry, "shifted", arguments);
  results.proposed = drive_crossing(defaults, proposed_crossing(), "as proposed", arguments);
  results.hallway = drive_hallway(arguments.quick ? defaults : all, defaults, arguments);

  if (!arguments.shard.is_all()) return true;

  fmt::print("{}\n{}\n", crossing_table(results.crossing), hallway_table(hallway_rows(results.hallway)));
  const std::vector<Criterion> criteria = anticipation_criteria(results);
  const std::vector<Criterion> published = published_criteria(results);
  fmt::print("{}as published:\n{}", criteria_text(criteria), criteria_text(published));
  return write_report({.subject = subject,
                       .judged = "the planners by their defaults, ideal senses",
                       .criteria = criteria,
                       .published = published_values(results),
                       .results = anticipation_json(results),
                       .page = anticipation_page(results),
                       .other_readings = {{"the planners as published", published}}},
                      arguments);
}

}  // namespace

bool reproduce_pteb(const ReproduceArguments& arguments) { return reproduce("pteb", arguments); }
bool reproduce_eteb(const ReproduceArguments& arguments) { return reproduce("eteb", arguments); }

}  // namespace bw
