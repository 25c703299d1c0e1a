#include <algorithm>
#include <charconv>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "components/tools/drive_page/drive_page.hpp"
#include "components/tools/evaluate/suite.hpp"
#include "components/tools/evaluate/suite_report.hpp"
#include "components/tools/program/drive.hpp"
#include "runtime/atomic_file.hpp"
#include "runtime/cli/signals.hpp"
#include "runtime/cli/verb.hpp"

namespace bw {
namespace {

struct EvaluateOptions {
  std::vector<std::string> suites;
  std::vector<std::string> planners = {""};  ///< empty: the graph's own
  std::vector<std::string> set;
  std::string seeds;
  std::string only_episode;
  std::string shard;
  std::string json;
  std::string svg_dir;
  std::string html_dir;
  double at_least = 0.0;
};

/// One drive still to be done.
struct Job {
  std::size_t suite = 0;
  std::size_t episode = 0;
  std::int64_t seed = 1;
  std::string planner;
};

/// Two whole numbers, 0 to 10^9, around `separator`; nothing for any other text.
std::optional<std::pair<std::int64_t, std::int64_t>> number_pair(const std::string& text,
                                                                 const std::string& separator) {
  constexpr std::int64_t kLargest = 1'000'000'000;
  std::pair<std::int64_t, std::int64_t> out;
  const std::size_t middle = text.find(separator);
  if (middle == std::string::npos) return std::nullopt;
  const auto read = [](const char* begin, const char* end, std::int64_t& value) {
    const auto [stop, error] = std::from_chars(begin, end, value);
    return error == std::errc() && stop == end && value >= 0 && value <= kLargest;
  };
  const char* begin = text.data();
  if (!read(begin, begin + middle, out.first)) return std::nullopt;
  if (!read(begin + middle + separator.size(), begin + text.size(), out.second)) return std::nullopt;
  return out;
}

SeedRange seeds_of(const EvaluateOptions& options, const Suite& suite) {
  if (options.seeds.empty()) return suite.options.seeds;
  const auto range = number_pair(options.seeds, "..");
  if (!range || range->second < range->first) {
    throw std::runtime_error("--seeds " + options.seeds + ": must be A..B with A <= B");
  }
  return {range->first, range->second};
}

/// The jobs of this shard: every n-th, so that shards are alike in length.
std::vector<Job> jobs_of(const EvaluateOptions& options, const std::vector<Suite>& suites) {
  std::pair<std::int64_t, std::int64_t> shard{1, 1};
  if (!options.shard.empty()) {
    const auto given = number_pair(options.shard, "/");
    if (!given || given->first < 1 || given->first > given->second) {
      throw std::runtime_error("--shard " + options.shard + ": must be I/N with 1 <= I <= N");
    }
    shard = *given;
  }
  std::vector<Job> jobs;
  std::int64_t index = 0;
  for (std::size_t suite = 0; suite < suites.size(); ++suite) {
    const SeedRange seeds = seeds_of(options, suites[suite]);
    const std::vector<SuiteEpisode>& episodes = suites[suite].options.episodes;
    for (const std::string& planner : options.planners) {
      for (std::size_t episode = 0; episode < episodes.size(); ++episode) {
        if (!options.only_episode.empty() && episodes[episode].name != options.only_episode) continue;
        for (std::int64_t seed = seeds.first; seed <= seeds.last; ++seed) {
          if (index++ % shard.second == shard.first - 1) jobs.push_back({suite, episode, seed, planner});
        }
      }
    }
  }
  if (jobs.empty()) throw std::runtime_error("no episode is chosen");
  return jobs;
}

Graph graph_of(const Suite& suite, const Job& job, const std::vector<std::string>& set) {
  Graph graph = suite.graph_of(job.episode);
  for (const std::string& text : set) apply_override(graph, parse_override(text));
  const ComponentNode* planner = find_type(graph, "local_planner", "");
  if (planner == nullptr) throw std::runtime_error(suite.graph.string() + ": has no local_planner");
  if (find_type(graph, "evaluation", "") == nullptr) {
    throw std::runtime_error(suite.graph.string() + ": has no evaluation, nothing would be judged");
  }
  if (!job.planner.empty()) {
    for (const ComponentNode& node : graph.components)
      if (node.type == "local_planner")
        apply_override(graph, parse_override(node.name + ".algorithm=" + job.planner));
  }
  return graph;
}

std::string planner_of(const nlohmann::json& card, const Job& job) {
  const nlohmann::json& planner = card["planner"];
  return planner.is_object() ? planner.value("name", job.planner) : job.planner;
}

/// Of the files of one drive. Names of episodes are unique in a suite.
std::string file_stem(const EvaluateOptions& options, const Suite& suite, const Job& job) {
  const std::string before = options.suites.size() == 1
                                 ? ""
                                 : std::filesystem::path(options.suites[job.suite]).stem().string() + "_";
  const std::string planner = job.planner.empty() ? "" : "_" + job.planner;
  return fmt::format("{}{}{}_seed{}", before, suite.options.episodes[job.episode].name, planner, job.seed);
}

/// A drive that failed once more, the same to the byte, and recorded: few fail, so that this costs less than to record them all.
std::string page_of(const EvaluateOptions& options, const Suite& suite, const Job& job,
                    DriveSettings settings, const std::string& samples_sha256) {
  settings.svg.clear();
  settings.html = std::filesystem::path(options.html_dir) / (file_stem(options, suite, job) + ".html");
  const DriveResult again = drive(graph_of(suite, job, options.set), settings);
  if (cli::interrupted()) return "";
  if (!again.page_fault.empty()) std::cerr << "--html: " << again.page_fault << "\n";
  if (again.json.value("samples_sha256", "") != samples_sha256)
    std::cerr << settings.html.string() << ": driven again it was not the same drive\n";
  return std::filesystem::exists(settings.html) ? settings.html.string() : "";
}

EpisodeResult drive_job(const EvaluateOptions& options, const Suite& suite, const Job& job) {
  DriveSettings settings;
  settings.host.clock = ClockMode::lockstep;
  settings.host.seed = static_cast<std::uint64_t>(job.seed);
  settings.longest = Duration::seconds(suite.options.time_limit);
  settings.contacts = true;
  if (!options.svg_dir.empty())
    settings.svg = std::filesystem::path(options.svg_dir) / (file_stem(options, suite, job) + ".svg");
  const nlohmann::json card = drive(graph_of(suite, job, options.set), settings).json;
  EpisodeResult result{suite.options.episodes[job.episode].name, job.seed, planner_of(card, job), card};
  if (!options.html_dir.empty() && !result.succeeded() && !cli::interrupted())
    result.page = page_of(options, suite, job, settings, card.value("samples_sha256", ""));
  return result;
}

/// One suite as an object, several as {suites: [...]}; how many drives were planned and done stands in either.
/// Written after every drive, so that of an evaluation that is killed there is a file that says so.
void write_json(const std::string& file, const std::vector<SuiteResult>& results, std::size_t planned) {
  if (file.empty()) return;
  nlohmann::json reports = nlohmann::json::array();
  for (const SuiteResult& result : results) reports.push_back(to_json(result));
  nlohmann::json all = reports.size() == 1 ? reports.front() : nlohmann::json{{"suites", std::move(reports)}};
  std::size_t driven = 0;
  for (const SuiteResult& result : results) driven += result.episodes.size();
  all["planned"] = planned;
  all["driven"] = driven;
  all["complete"] = driven == planned;
  write_file_atomically(file, all.dump(2) + "\n");
}

bool enough_succeeded(const SuiteResult& result, double share) {
  const nlohmann::json summary = to_json(result)["summary"];
  return std::all_of(summary.begin(), summary.end(), [share](const nlohmann::json& row) {
    return row["successes"].get<double>() >= share * row["episodes"].get<double>();
  });
}

int evaluate(const EvaluateOptions& options) {
  if (!options.html_dir.empty()) require_page("--html " + options.html_dir);
  std::vector<Suite> suites;
  std::vector<SuiteResult> results;
  for (const std::string& file : options.suites) {
    suites.push_back(load_suite(file));
    results.push_back({file, {}});
  }
  const std::vector<Job> jobs = jobs_of(options, suites);
  // A mistake in the last episode is found before the first one is driven.
  for (const Job& job : jobs) graph_of(suites[job.suite], job, options.set);

  std::size_t driven = 0;
  write_json(options.json, results, jobs.size());
  cli::catch_interrupts();
  for (const Job& job : jobs) {
    const EpisodeResult result = drive_job(options, suites[job.suite], job);
    if (cli::interrupted()) break;
    results[job.suite].episodes.push_back(result);
    write_json(options.json, results, jobs.size());
    std::cerr << fmt::format("[{}/{}] {}{}\n", ++driven, jobs.size(), result.succeeded() ? "" : "FAILED ",
                             in_a_line(result));
  }

  std::cout << in_words(results);
  if (driven < jobs.size()) std::cout << fmt::format("interrupted: {} of {} drives\n", driven, jobs.size());
  const bool enough = std::all_of(results.begin(), results.end(), [&](const SuiteResult& result) {
    return enough_succeeded(result, options.at_least);
  });
  return driven == jobs.size() && enough ? 0 : 1;
}

CLI::App* add_evaluate(CLI::App& app, int& status) {
  auto options = std::make_shared<EvaluateOptions>();
  CLI::App* verb = app.add_subcommand("evaluate", "Drives suites of episodes in lock-step and sums up");
  verb->add_option("SUITE", options->suites, "Suite files")->required();
  verb->add_option("--planners", options->planners,
                   "Algorithms of local_planner, separated by commas; default: the graph's own")
      ->delimiter(',');
  verb->add_option("--seeds", options->seeds, "A..B instead of the suite's seeds");
  verb->add_option("--episode", options->only_episode, "Only the episode of this name");
  verb->add_option("--set", options->set, "component.param=value for all episodes, as often as needed")
      ->allow_extra_args(false);
  verb->add_option("--shard", options->shard, "I/N: only every N-th drive, beginning with the I-th");
  verb->add_option(
      "--json", options->json,
      "Writes summary and score cards here, after every drive; `complete` tells whether all are in it");
  verb->add_option("--svg-dir", options->svg_dir, "Writes a picture of every drive into this folder");
  verb->add_option(
      "--html", options->html_dir,
      "Writes a page of every drive that failed into this folder: it plays the drive, and needs no server");
  verb->add_option("--at-least", options->at_least,
                   "Exit status 1 when a planner's share of successes is lower")
      ->check(CLI::Range(0.0, 1.0));
  verb->callback([options, &status] { status = evaluate(*options); });
  return verb;
}

}  // namespace

BW_VERB(measure, "evaluate", add_evaluate)

}  // namespace bw
