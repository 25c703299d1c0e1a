#include "components/program/evaluate.hpp"

#include <charconv>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "components/program/drive.hpp"
#include "components/program/suite.hpp"
#include "components/program/suite_report.hpp"
#include "runtime/atomic_file.hpp"
#include "runtime/cli/signals.hpp"

namespace bw {
namespace {

struct EvaluateOptions {
  std::string suite;
  std::vector<std::string> planners = {""};  ///< empty: the graph's own
  std::vector<std::string> set;
  std::string seeds;
  std::string only_episode;
  std::string shard;
  std::string json;
  std::string svg_dir;
  double at_least = 0.0;
};

/// One drive still to be done.
struct Job {
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
std::vector<Job> jobs_of(const EvaluateOptions& options, const Suite& suite) {
  std::pair<std::int64_t, std::int64_t> shard{1, 1};
  if (!options.shard.empty()) {
    const auto given = number_pair(options.shard, "/");
    if (!given || given->first < 1 || given->first > given->second) {
      throw std::runtime_error("--shard " + options.shard + ": must be I/N with 1 <= I <= N");
    }
    shard = *given;
  }
  const SeedRange seeds = seeds_of(options, suite);
  std::vector<Job> jobs;
  std::int64_t index = 0;
  for (const std::string& planner : options.planners) {
    for (std::size_t episode = 0; episode < suite.options.episodes.size(); ++episode) {
      const std::string& name = suite.options.episodes[episode].name;
      if (!options.only_episode.empty() && name != options.only_episode) continue;
      for (std::int64_t seed = seeds.first; seed <= seeds.last; ++seed) {
        if (index++ % shard.second == shard.first - 1) jobs.push_back({episode, seed, planner});
      }
    }
  }
  if (jobs.empty()) throw std::runtime_error("no episode of " + options.suite + " is chosen");
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
    apply_override(graph, parse_override(planner->name + ".algorithm=" + job.planner));
  }
  return graph;
}

std::string planner_of(const nlohmann::json& card, const Job& job) {
  const nlohmann::json& planner = card["planner"];
  return planner.is_object() ? planner.value("name", job.planner) : job.planner;
}

int evaluate(const EvaluateOptions& options) {
  const Suite suite = load_suite(options.suite);
  const std::vector<Job> jobs = jobs_of(options, suite);
  // A mistake in the last episode is found before the first one is driven.
  for (const Job& job : jobs) graph_of(suite, job, options.set);

  std::vector<EpisodeResult> results;
  cli::catch_interrupts();
  for (const Job& job : jobs) {
    DriveOptions drive_options{
        .host = {.clock = ClockMode::lockstep, .seed = static_cast<std::uint64_t>(job.seed)},
        .longest = Duration::seconds(suite.options.time_limit)};
    const std::string& name = suite.options.episodes[job.episode].name;
    if (!options.svg_dir.empty()) {
      const std::string planner = job.planner.empty() ? "" : "_" + job.planner;
      drive_options.svg =
          std::filesystem::path(options.svg_dir) / fmt::format("{}{}_seed{}.svg", name, planner, job.seed);
    }
    const nlohmann::json card = drive(graph_of(suite, job, options.set), drive_options).json;
    if (cli::interrupted()) break;
    const EpisodeResult result{name, job.seed, planner_of(card, job), card};
    std::cerr << fmt::format("[{}/{}] {}{}\n", results.size() + 1, jobs.size(),
                             result.succeeded() ? "" : "FAILED ", in_a_line(result));
    results.push_back(result);
  }

  const nlohmann::json report = suite_json(options.suite, results);
  if (!options.json.empty()) write_file_atomically(options.json, report.dump(2) + "\n");
  std::cout << in_words(report, results);
  if (results.size() < jobs.size()) return 1;
  for (const auto& row : report["summary"]) {
    if (row["successes"].get<double>() < options.at_least * row["episodes"].get<double>()) return 1;
  }
  return 0;
}

}  // namespace

void add_evaluate(CLI::App& app, int& status) {
  auto options = std::make_shared<EvaluateOptions>();
  CLI::App* verb = app.add_subcommand("evaluate", "Drives a suite of episodes in lock-step and sums up");
  verb->add_option("SUITE", options->suite, "Suite file")->required();
  verb->add_option("--planners", options->planners,
                   "Algorithms of local_planner, separated by commas; default: the graph's own")
      ->delimiter(',');
  verb->add_option("--seeds", options->seeds, "A..B instead of the suite's seeds");
  verb->add_option("--episode", options->only_episode, "Only the episode of this name");
  verb->add_option("--set", options->set, "component.param=value for all episodes, as often as needed")
      ->allow_extra_args(false);
  verb->add_option("--shard", options->shard, "I/N: only every N-th drive, beginning with the I-th");
  verb->add_option("--json", options->json, "Writes summary and score cards here");
  verb->add_option("--svg-dir", options->svg_dir, "Writes a picture of every drive into this folder");
  verb->add_option("--at-least", options->at_least,
                   "Exit status 1 when a planner's share of successes is lower")
      ->check(CLI::Range(0.0, 1.0));
  verb->callback([options, &status] { status = evaluate(*options); });
}

}  // namespace bw
