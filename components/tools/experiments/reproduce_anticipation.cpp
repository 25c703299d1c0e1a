// bandwagon reproduce pteb|eteb: E5 in process, then E6 as drives of the hallway suite, by ideal senses and by own.
#include <cctype>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include <fmt/format.h>

#include "components/tools/evaluate/suite.hpp"
#include "components/tools/experiments/anticipation_report.hpp"
#include "components/tools/experiments/honesty.hpp"
#include "components/tools/experiments/project_file.hpp"
#include "components/tools/experiments/reproduce.hpp"
#include "components/tools/program/drive.hpp"
#include "components/viewer/adaptor/site.hpp"
#include "runtime/atomic_file.hpp"
#include "runtime/cli/signals.hpp"

namespace bw {
namespace {

constexpr int kRuns = 40;
constexpr int kQuickRuns = 5;
constexpr std::int64_t kQuickSeeds = 2;
constexpr int kMostPages = 20;                // of drives that failed: some MB each
constexpr std::int64_t kOwnSensesSeeds = 10;  // half of those by ideal senses: reported, not judged

std::vector<CrossingResult> drive_crossing(const std::vector<CrossingEntry>& entries,
                                           const CrossingGeometry& geometry, int runs) {
  std::vector<CrossingResult> results;
  for (const CrossingEntry& entry : entries) {
    std::cerr << fmt::format("people crossing, {}: {} runs\n", entry.label, runs);
    results.push_back(run_crossing(entry, geometry, runs));
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
  if (quick) last_seed = seeds.first + (own_senses ? 1 : kQuickSeeds) - 1;
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

/// Beside the results; planners are called by words.
std::string page_name(const HallwayDrive& drive) {
  std::string name = fmt::format("hallway_{}_{}_{}_{}_seed{}.html", drive.episode, drive.senses(),
                                 drive.people_react ? "reacting" : "blind", drive.planner, drive.seed);
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.') c = '_';
  return "failed/" + name;
}

/// A drive that failed once more, the same to the byte, and recorded: few fail, so that this costs less than to record them all.
void add_page(HallwayDrive& row, const Suite& suite, const HallwayJob& job, DriveSettings settings,
              const std::filesystem::path& out) {
  const std::string name = page_name(row);
  settings.html = out / name;
  const DriveResult again = drive(hallway_graph(suite, job), settings);
  if (!again.page_fault.empty()) std::cerr << again.page_fault << "\n";
  if (std::filesystem::exists(settings.html)) row.page = name;
}

/// By ideal senses all `entries`, then by its own the planners' defaults.
std::vector<HallwayDrive> drive_hallway(const std::vector<CrossingEntry>& entries,
                                        const std::vector<CrossingEntry>& defaults,
                                        const ReproduceArguments& arguments) {
  const bool quick = arguments.quick;
  int pages = viewer::page_files().empty() ? kMostPages : 0;  // of a program without the page none
  const Suite suite = load_suite(project_file("config/suites/hallway.yaml"));
  std::vector<HallwayJob> jobs = hallway_jobs(suite, entries, false, quick);
  for (HallwayJob& job : hallway_jobs(suite, defaults, true, quick)) jobs.push_back(std::move(job));
  // A wrong parameter is found before the first drive.
  for (const HallwayJob& job : jobs) hallway_graph(suite, job);
  std::vector<HallwayDrive> drives;
  cli::catch_interrupts();
  for (const HallwayJob& job : jobs) {
    const DriveSettings options{
        .host = {.clock = ClockMode::lockstep, .seed = static_cast<std::uint64_t>(job.seed)},
        .longest = Duration::seconds(suite.options.time_limit)};
    const DriveResult result = drive(hallway_graph(suite, job), options);
    if (cli::interrupted()) throw std::runtime_error("interrupted");
    HallwayDrive row = hallway_drive(job.entry.label, suite.options.episodes[job.episode].name,
                                     job.people_react, job.seed, result.json);
    row.own_senses = job.own_senses;
    if (!row.succeeded() && pages < kMostPages) {
      add_page(row, suite, job, options, arguments.out);
      ++pages;
    }
    if (cli::interrupted()) throw std::runtime_error("interrupted");
    drives.push_back(row);
    std::cerr << fmt::format(
        "[{}/{}] hallway {}, {} senses, people {}, {} seed {}: {}, largest CI {:.2f}\n", drives.size(),
        jobs.size(), row.episode, row.senses(), row.people_react ? "react" : "do not react", row.planner,
        row.seed, row.succeeded() ? fmt::format("{:.1f} s", row.time) : "FAILED", row.max_collision_index);
  }
  return drives;
}

bool reproduce(const std::string& subject, const ReproduceArguments& arguments) {
  const bool with_eteb = subject == "eteb";
  const int runs = arguments.quick ? kQuickRuns : kRuns;
  const std::vector<CrossingEntry> defaults = default_entries(with_eteb);
  std::vector<CrossingEntry> all = defaults;
  for (CrossingEntry& entry : published_entries(with_eteb)) all.push_back(std::move(entry));

  AnticipationResults results{.subject = subject};
  results.crossing = drive_crossing(all, results.geometry, runs);
  results.proposed = drive_crossing(defaults, proposed_crossing(), runs);
  results.hallway = drive_hallway(arguments.quick ? defaults : all, defaults, arguments);

  nlohmann::ordered_json json = anticipation_json(results);
  json["tuned_to_published"] = tuned_to_published(subject);
  write_file_atomically(arguments.out / "results.json", json.dump(2) + "\n");
  write_file_atomically(arguments.out / "index.html", anticipation_page(results));
  fmt::print("{}\n{}\n", crossing_table(results.crossing), hallway_table(hallway_rows(results.hallway)));
  const std::vector<Criterion> criteria = anticipation_criteria(results);
  const std::vector<Criterion> published = published_criteria(results);
  fmt::print("{}as published:\n{}", criteria_text(criteria), criteria_text(published));
  const std::string not_judged = published.empty() ? "the published forms were not driven"
                                                   : verdict("the planners as published", published);
  fmt::print("{}not judged by it: {}\nwritten: {}\n",
             closing_lines(subject, "the planners by their defaults, ideal senses", criteria), not_judged,
             (arguments.out / "index.html").string());
  return all_met(criteria);
}

}  // namespace

bool reproduce_pteb(const ReproduceArguments& arguments) { return reproduce("pteb", arguments); }
bool reproduce_eteb(const ReproduceArguments& arguments) { return reproduce("eteb", arguments); }

}  // namespace bw
