#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <tuple>

#include <fmt/format.h>

#include "components/lab/evaluate/jobs.hpp"
#include "components/lab/evaluate/merge.hpp"
#include "components/lab/evaluate/parallel.hpp"
#include "components/lab/evaluate/suite_report.hpp"
#include "components/lab/failures/failure_album.hpp"
#include "components/lab/report/report_page.hpp"
#include "components/lab/shards/graph_text.hpp"
#include "components/program/drive.hpp"
#include "components/program/drive_page/drive_page.hpp"
#include "runtime/atomic_file.hpp"
#include "runtime/cli/signals.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/temporary_folder.hpp"

namespace bw {
namespace {

Graph graph_of(const EvaluateOptions& options, const Suite& suite, const Job& job) {
  Graph graph = suite.graph_of(job.episode, job.variant);
  for (const std::string& text : options.set) apply_override(graph, parse_override(text));
  if (!job.value.empty())
    apply_override(graph, parse_override(varied_of(options).parameter + "=" + job.value));
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

/// With the variant that it drove under.
std::string planner_of(const nlohmann::json& card, const Job& job) {
  const nlohmann::json& planner = card["planner"];
  const std::string name =
      job.planner.empty() && planner.is_object() ? planner.value("name", "") : job.planner;
  return job.variant.empty() ? name : name + " " + job.variant;
}

std::string episode_name(const Suite& suite, const Job& job) {
  return suite.options.episodes[job.episode].name + (job.value.empty() ? "" : "_" + job.value);
}

/// Of the files of one drive. Names of episodes are unique in a suite; of several suites each stands before
/// them, unless they all begin with it anyway.
std::string file_stem(const EvaluateOptions& options, const Suite& suite, const Job& job) {
  const std::string name = std::filesystem::path(options.suites[job.suite]).stem().string() + "_";
  const std::vector<SuiteEpisode>& episodes = suite.options.episodes;
  const bool is_said = std::all_of(episodes.begin(), episodes.end(), [&](const SuiteEpisode& episode) {
    return episode.name.starts_with(name);
  });
  const std::string before = options.suites.size() == 1 || is_said ? "" : name;
  std::string planner = job.planner.empty() ? "" : "_" + job.planner;
  std::ranges::replace(planner, '/', '_');  // of a program
  if (!job.variant.empty()) planner += "_" + job.variant;
  return fmt::format("{}{}{}_seed{}", before, episode_name(suite, job), planner, job.seed);
}

/// A drive that failed once more, the same to the byte, and recorded: few fail, so that this costs less than
/// to record them all.
std::string page_of(const EvaluateOptions& options, const Suite& suite, const Job& job,
                    DriveSettings settings, const std::string& samples_sha256) {
  settings.svg.clear();
  settings.html = std::filesystem::path(options.html_dir) / (file_stem(options, suite, job) + ".html");
  const DriveResult again = drive(graph_of(options, suite, job), settings);
  if (cli::interrupted()) return "";
  if (!again.page_fault.empty()) std::cerr << "--html: " << again.page_fault << "\n";
  if (again.json.value("samples_sha256", "") != samples_sha256)
    std::cerr << settings.html.string() << ": driven again it was not the same drive\n";
  return std::filesystem::exists(settings.html) ? settings.html.string() : "";
}

/// Of several robots each that was touched or did not arrive; of one that one.
void picture_failure(FailureAlbum& album, const EpisodeResult& result, const DriveResult& driven) {
  const std::string line = in_a_line(result);
  const std::size_t colon = line.find(": ");
  for (const HeardDrive& one : driven.heard) {
    const nlohmann::json& card = one.robot.empty() ? driven.json : driven.json["robots"][one.robot];
    if (is_success(card) || album.is_full() || one.recording.moments.empty()) continue;
    album.add({.title = line.substr(0, colon) + (one.robot.empty() ? "" : ", " + one.robot),
               .outcome = line.substr(colon + 2) + (result.is_excused() ? ", could not succeed" : ""),
               .reached = card.value("reached", false),
               .contacts = one.contacts},
              one.recording);
  }
}

EpisodeResult drive_job(const EvaluateOptions& options, const Suite& suite, const Job& job,
                        FailureAlbum* album) {
  DriveSettings settings;
  settings.host.clock = ClockMode::lockstep;
  settings.host.alone = true;
  settings.host.seed = static_cast<std::uint64_t>(job.seed);
  settings.longest = Duration::seconds(suite.options.time_limit);
  settings.contacts = true;
  if (!options.svg_dir.empty())
    settings.svg = std::filesystem::path(options.svg_dir) / (file_stem(options, suite, job) + ".svg");
  DriveResult driven;
  try {
    driven = drive(graph_of(options, suite, job), settings);
  } catch (const RunFailed& failure) {
    driven.json = {{"reached", false}, {"reason", failure.what()}, {kRunFailed, true}, {"planner", nullptr}};
  }
  // Who sets results side by side: other conditions are another suite, and values of --vary are departures of one start.
  if (!job.variant.empty()) driven.json["variant"] = job.variant;
  if (!job.value.empty()) driven.json["episode"] = suite.options.episodes[job.episode].name;
  const nlohmann::json& card = driven.json;
  EpisodeResult result{episode_name(suite, job), job.seed, planner_of(card, job), card};
  if (result.run_failed()) return result;
  if (album != nullptr && !result.succeeded() && !cli::interrupted()) picture_failure(*album, result, driven);
  if (!options.html_dir.empty() && !result.succeeded() && !cli::interrupted())
    result.page = page_of(options, suite, job, settings, card.value("samples_sha256", ""));
  return result;
}

/// `against` where it is one of the rows; else the first is taken: of a suite that was interrupted before it
/// came to that planner.
std::string known_row(const std::vector<ComparedRow>& rows, const std::string& against) {
  const bool is_known =
      std::any_of(rows.begin(), rows.end(), [&](const auto& row) { return row.name == against; });
  return is_known ? against : "";
}

/// What is told of all drives at the end: reckoned once, for words, JSON and exit status.
struct Report {
  std::vector<std::vector<PlannerSummary>> planners;          ///< of each suite
  std::vector<std::optional<ComparisonSummary>> comparisons;  ///< of each suite that was driven
  std::optional<ComparisonSummary> of_all;                    ///< of several suites together
};

Report report_of(const std::vector<SuiteResult>& results, const std::string& against) {
  const auto compare = [&](const std::vector<SuiteResult>& some) -> std::optional<ComparisonSummary> {
    const std::vector<ComparedRow> rows = compared(some);
    if (rows.empty()) return std::nullopt;
    return summarize(rows, known_row(rows, against));
  };
  Report report;
  for (const SuiteResult& result : results) {
    report.planners.push_back(summarize(result));
    report.comparisons.push_back(compare({result}));
  }
  if (results.size() > 1) report.of_all = compare(results);
  return report;
}

/// Refuses the name of a planner that does not drive.
void check_against(const EvaluateOptions& options) {
  std::vector<ComparedRow> rows;
  for (const std::string& planner : options.planners) {
    if (planner.empty()) return;  // the graphs name it
    for (const std::string& variant : options.variants)
      rows.push_back({variant.empty() ? planner : planner + " " + variant, {}});
  }
  row_against(rows, options.against);
}

/// One suite as an object, several as {suites: [...]}; how many drives were planned and done stands in
/// either.
/// Written after every drive, so that of an evaluation that is killed there is a file that says so;
/// comparisons when all is done.
void write_json(const std::string& file, const std::vector<SuiteResult>& results, std::size_t planned,
                const Provenance& made, const Report* report = nullptr) {
  if (file.empty()) return;
  nlohmann::json reports = nlohmann::json::array();
  for (std::size_t i = 0; i < results.size(); ++i) {
    reports.push_back(to_json(results[i], report != nullptr ? report->planners[i] : summarize(results[i])));
    if (report != nullptr && report->comparisons[i])
      reports.back()["comparison"] = nlohmann::json(to_json(*report->comparisons[i]));
  }
  nlohmann::json all = reports.size() == 1 ? reports.front() : nlohmann::json{{"suites", std::move(reports)}};
  if (report != nullptr && report->of_all) all["comparison"] = nlohmann::json(to_json(*report->of_all));
  std::size_t driven = 0;
  for (const SuiteResult& result : results) driven += result.episodes.size();
  all["planned"] = planned;
  all["driven"] = driven;
  all["complete"] = driven == planned;
  static const nlohmann::json kCitation = citation();  // of this process: it is written after every drive
  all["made"] = to_json(made);
  for (const char* key : {"date", "command"}) all["made"][key] = kCitation[key];
  write_file_atomically(file, all.dump(2) + "\n");
}

bool enough_succeeded(const Report& report, double share) {
  const auto is_enough = [share](const PlannerSummary& row) { return row.successes >= share * row.episodes; };
  return std::all_of(report.planners.begin(), report.planners.end(), [&](const auto& planners) {
    return std::all_of(planners.begin(), planners.end(), is_enough);
  });
}

bool any_run_failed(const std::vector<SuiteResult>& results) {
  return std::ranges::any_of(results, [](const SuiteResult& result) {
    return std::ranges::any_of(result.episodes, &EpisodeResult::run_failed);
  });
}

/// Failures, rates, means and pairs, of each suite and of all.
std::string report_in_words(const std::vector<SuiteResult>& results, const Report& report) {
  std::string out = in_words(results, report.planners);
  const auto add = [&](const std::string& name, const std::optional<ComparisonSummary>& comparison) {
    if (comparison) out += "\n" + name + "\n" + in_words(*comparison);
  };
  for (std::size_t i = 0; i < results.size(); ++i)
    add(std::filesystem::path(results[i].suite).stem().string(), report.comparisons[i]);
  add("all suites", report.of_all);
  return out;
}

/// Says and writes all that is to be said of the drives; the exit status.
int conclude(const EvaluateOptions& options, const std::vector<SuiteResult>& results, std::size_t planned,
             const Provenance& made) {
  const Report report = report_of(results, options.against);
  std::cout << report_in_words(results, report);
  write_json(options.json, results, planned, made, &report);
  return enough_succeeded(report, options.at_least) && !any_run_failed(results) ? 0 : 1;
}

/// Files of earlier evaluations under one label.
struct Labelled {
  std::string label;
  std::vector<ResultsFile> files;
};

std::vector<Labelled> labelled(const std::vector<std::string>& from) {
  std::vector<Labelled> all;
  for (const std::string& text : from) {
    const std::size_t colon = text.find(':');
    const std::string label = colon == std::string::npos ? "" : text.substr(0, colon);
    auto found = std::ranges::find(all, label, &Labelled::label);
    if (found == all.end()) found = all.insert(all.end(), {label, {}});
    found->files.push_back(read_results_file(colon == std::string::npos ? text : text.substr(colon + 1)));
  }
  return all;
}

/// Suites with `more` of their drives, whose planners are called after the label.
void append(std::vector<SuiteResult>& results, std::vector<SuiteResult> more, const std::string& label) {
  for (SuiteResult& part : more) {
    auto result = std::ranges::find(results, part.suite, &SuiteResult::suite);
    if (result == results.end()) result = results.insert(result, {part.suite, {}});
    for (EpisodeResult& episode : part.episodes) {
      if (!label.empty()) episode.planner += " " + label;
      result->episodes.push_back(std::move(episode));
    }
  }
}

/// Drives of earlier evaluations, summed up again.
int sum_up(const EvaluateOptions& options) {
  std::vector<SuiteResult> results;
  const std::vector<Labelled> all = labelled(options.from);
  for (const Labelled& one : all) {
    // Shards are one evaluation, whatever else there is stands beside it.
    if (std::ranges::any_of(one.files, [](const ResultsFile& file) { return file.made.of > 1; }))
      append(results, merge(one.files), one.label);
    else
      for (const ResultsFile& file : one.files) append(results, file.results, one.label);
  }
  std::size_t driven = 0;
  for (const SuiteResult& result : results) driven += result.episodes.size();
  row_against(compared(results), options.against);
  Provenance made;
  if (all.size() == 1) made = all.front().files.front().made;
  made.shard = made.of = 1;
  return conclude(options, results, driven, made);
}

/// Of all drives that one run drives: what they depend on.
std::string text_of(const EvaluateOptions& options, const std::vector<Suite>& suites,
                    const std::vector<Job>& jobs) {
  std::string text;
  std::map<std::tuple<std::size_t, std::size_t, std::string, std::string, std::string>, std::string> graphs;
  for (const Job& job : jobs) {
    std::string& graph = graphs[{job.suite, job.episode, job.planner, job.variant, job.value}];
    if (graph.empty()) {
      // A mistake in the last episode is found before the first one is driven.
      graph = text_of(graph_of(options, suites[job.suite], job));
      text += graph;
    }
    text += fmt::format("{} {} {} {}\n", job.suite, job.episode, job.seed, job.value);
  }
  return text;
}

/// By processes of their own. Shards stay beside the result until it is written.
int evaluate_in_shards(const EvaluateOptions& options, std::size_t planned, const Provenance& made) {
  if (!options.failures_dir.empty() || !options.shard.empty())
    throw std::runtime_error("--jobs goes neither with --failures nor with --shard");
  std::optional<TemporaryFolder> temporary;
  if (options.json.empty()) temporary.emplace();
  const std::filesystem::path folder =
      temporary ? temporary->path() : std::filesystem::path(options.json + ".shards");
  const std::vector<ResultsFile> shards = drive_in_shards(options, planned, made, folder);
  if (shards.empty()) {
    std::cout << fmt::format("interrupted: the same command goes on with what is in {}\n", folder.string());
    return 1;
  }
  const int status = conclude(options, merge(shards), planned, made);
  std::filesystem::remove_all(folder);
  return status;
}

int evaluate(const EvaluateOptions& options) {
  if (!options.from.empty()) return sum_up(options);
  if (options.suites.empty()) throw std::runtime_error("a suite must be named, or --from a file");
  check_against(options);
  if (!options.html_dir.empty()) require_page("--html " + options.html_dir);
  if (!options.failures_dir.empty()) require_report_page("--failures " + options.failures_dir);
  std::vector<Suite> suites;
  std::vector<SuiteResult> results;
  for (const std::string& file : options.suites) {
    suites.push_back(load_suite(file));
    results.push_back({file, {}});
  }
  const std::vector<Job> all = jobs_of(options, suites);
  const Shard shard = shard_of(options);
  const std::vector<Job> jobs = part_of(all, shard);
  const Provenance made = provenance_of(text_of(options, suites, all), shard.number, shard.of);
  cli::catch_interrupts();
  if (options.jobs > 1) return evaluate_in_shards(options, all.size(), made);

  std::size_t driven = 0;
  write_json(options.json, results, jobs.size(), made);
  std::optional<FailureAlbum> album;
  if (!options.failures_dir.empty()) album.emplace(options.failures_dir, write_report_page);
  for (const Job& job : jobs) {
    const EpisodeResult result = drive_job(options, suites[job.suite], job, album ? &*album : nullptr);
    if (cli::interrupted()) break;
    results[job.suite].episodes.push_back(result);
    write_json(options.json, results, jobs.size(), made);
    std::cerr << fmt::format("[{}/{}] {}{}\n", ++driven, jobs.size(), result.succeeded() ? "" : "FAILED ",
                             in_a_line(result));
  }

  if (driven == jobs.size()) return conclude(options, results, jobs.size(), made);
  std::cout << report_in_words(results, report_of(results, options.against))
            << fmt::format("interrupted: {} of {} drives\n", driven, jobs.size());
  return 1;
}

void add_evaluate(cli::Verb verb) {
  auto options = std::make_shared<EvaluateOptions>();
  verb.option("SUITE", options->suites, "Suite files");
  verb.option(
          "--planners", options->planners,
          "Algorithms of local_planner, or programs that plan (a path with a slash), separated by commas; default: the graph's own")
      .separated_by_commas();
  verb.option("--seeds", options->seeds, "A..B instead of the suite's seeds");
  verb.option("--episode", options->only_episode, "Only the episode of this name");
  verb.option("--set", options->set, "component.param=value for all episodes, as often as needed")
      .one_each_time();
  verb.option("--jobs", options->jobs, "Drives at a time, in processes of their own (1)").within(1, 1024);
  verb.option("--shard", options->shard, "I/N: only every N-th drive, beginning with the I-th");
  verb.option(
      "--json", options->json,
      "Writes summary and score cards here, after every drive; `complete` tells whether all are in it");
  verb.option("--svg-dir", options->svg_dir, "Writes a picture of every drive into this folder");
  verb.option(
      "--html", options->html_dir,
      "Writes a page of every drive that failed into this folder: it plays the drive, and needs no server");
  verb.option(
      "--failures", options->failures_dir,
      "index.html in this folder shows the first 30 drives that failed, in a list and a picture each");
  verb.option("--variants", options->variants,
              "Conditions that the suite names, as ideal,own: each planner drives under each")
      .separated_by_commas();
  verb.option(
      "--vary", options->vary,
      "component.param=value,value,...: every episode once with each, as navigator.goal.delay=0.6,1.0,1.4");
  verb.option(
      "--against", options->against,
      "The planner that the others are held against, with its variant: \"eteb ideal\"; default: the first");
  verb.option(
          "--from", options->from,
          "[LABEL:]FILE: drives nothing, sums up what earlier evaluations wrote; a label tells planners of two files apart")
      .one_each_time();
  verb.option("--at-least", options->at_least, "Exit status 1 when a planner's share of successes is lower")
      .within(0.0, 1.0);
  verb.run([options] { return evaluate(*options); });
}

}  // namespace

BW_VERB(measure, "evaluate", "Drives suites of episodes in lock-step and sums up", add_evaluate)

}  // namespace bw
