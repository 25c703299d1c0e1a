#include "components/lab/evaluate/suite_report.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "runtime/base/quantile.hpp"

namespace bw {
namespace {

/// JSON writes null for what is not finite or was not measured.
std::optional<double> figure(const nlohmann::json& card, const char* key) {
  const auto found = card.find(key);
  if (found == card.end() || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

std::vector<double> figures(const std::vector<const EpisodeResult*>& drives, const char* key) {
  std::vector<double> values;
  for (const EpisodeResult* drive : drives) {
    if (const std::optional<double> value = figure(drive->card, key)) values.push_back(*value);
  }
  return values;
}

std::optional<double> mean_of(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

std::optional<double> largest(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  return *std::max_element(values.begin(), values.end());
}

std::optional<double> smallest(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  return *std::min_element(values.begin(), values.end());
}

/// Of a part of the card, such as the planner's own times; none where a card has no such part.
std::vector<double> part_figures(const std::vector<const EpisodeResult*>& drives, const char* part,
                                 const char* key) {
  std::vector<double> values;
  for (const EpisodeResult* drive : drives) {
    const auto found = drive->card.find(part);
    if (found == drive->card.end() || !found->is_object()) continue;
    if (const std::optional<double> value = figure(*found, key)) values.push_back(*value);
  }
  return values;
}

std::int64_t total(const std::vector<const EpisodeResult*>& drives, const char* key) {
  std::int64_t sum = 0;
  for (const EpisodeResult* drive : drives) sum += drive->card.value(key, std::int64_t{0});
  return sum;
}

/// Drives by planner, in the order of their first drives.
std::vector<std::pair<std::string, std::vector<const EpisodeResult*>>> by_planner(const SuiteResult& result) {
  std::vector<std::pair<std::string, std::vector<const EpisodeResult*>>> groups;
  for (const EpisodeResult& drive : result.episodes) {
    const auto same = [&](const auto& group) { return group.first == drive.planner; };
    auto found = std::find_if(groups.begin(), groups.end(), same);
    if (found == groups.end()) found = groups.insert(found, {drive.planner, {}});
    found->second.push_back(&drive);
  }
  return groups;
}

HitCounts hits_of(const std::vector<const EpisodeResult*>& drives) {
  HitCounts hits;
  for (const EpisodeResult* drive : drives) {
    const auto contacts = drive->card.find("contacts");
    if (contacts == drive->card.end() || !contacts->is_array()) continue;
    for (const nlohmann::json& contact : *contacts) hits.add(nlohmann::ordered_json(contact));
  }
  return hits;
}

PlannerSummary summary_of(const std::string& planner, const std::vector<const EpisodeResult*>& drives) {
  PlannerSummary s;
  s.planner = planner;
  s.episodes = static_cast<int>(drives.size());
  std::vector<const EpisodeResult*> reached;
  for (const EpisodeResult* drive : drives) {
    if (drive->card.value("reached", false)) {
      reached.push_back(drive);
      if (drive->card.value("collisions_at_speed", 1) == 0) ++s.reached_without_contact_at_speed;
    }
    if (drive->succeeded()) ++s.successes;
    if (!drive->is_excused()) ++s.possible;
  }
  s.reached = static_cast<int>(reached.size());
  s.wilson = wilson95(s.successes, s.episodes);
  s.wilson_possible = wilson95(s.successes, s.possible);
  s.hits = hits_of(drives);
  s.contacts = total(drives, "collisions");
  s.contacts_at_speed = total(drives, "collisions_at_speed");
  s.min_distance = smallest(figures(drives, "min_distance_m"));
  s.closest_person = smallest(figures(drives, "closest_person_m"));
  const std::vector<double> index = figures(drives, "max_collision_index");
  s.max_index = largest(index);
  if (!index.empty()) s.median_index = quantile(index, 0.5);
  s.mean_time = mean_of(figures(reached, "time_to_goal_s"));
  s.mean_jerk = mean_of(figures(drives, "rms_jerk_mps3"));
  s.mean_pose = mean_of(part_figures(drives, "localization", "rms_m"));
  s.max_pose = largest(part_figures(drives, "localization", "max_m"));
  s.mean_ms = mean_of(part_figures(drives, "planner", "mean_ms"));
  s.p95_ms = largest(part_figures(drives, "planner", "p95_ms"));
  s.max_ms = largest(part_figures(drives, "planner", "max_ms"));
  return s;
}

nlohmann::json number(const std::optional<double>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json();
}

nlohmann::json to_json(const PlannerSummary& s) {
  return {
      {"episodes", s.episodes},
      {"reached", s.reached},
      {"reached_without_contact_at_speed", s.reached_without_contact_at_speed},
      {"successes", s.successes},
      {"wilson95", {s.wilson.low, s.wilson.high}},
      {"possible", s.possible},
      {"wilson95_possible", {s.wilson_possible.low, s.wilson_possible.high}},
      {"hits", nlohmann::json(s.hits.to_json())},
      {"contacts", s.contacts},
      {"contacts_at_speed", s.contacts_at_speed},
      {"min_distance_m", number(s.min_distance)},
      {"closest_person_m", number(s.closest_person)},
      {"max_collision_index", {{"max", number(s.max_index)}, {"median", number(s.median_index)}}},
      {"mean_time_s", number(s.mean_time)},
      {"mean_rms_jerk_mps3", number(s.mean_jerk)},
      {"localization", {{"mean_rms_m", number(s.mean_pose)}, {"max_m", number(s.max_pose)}}},
      {"planner_ms", {{"mean", number(s.mean_ms)}, {"p95", number(s.p95_ms)}, {"max", number(s.max_ms)}}}};
}

std::string text(const std::optional<double>& value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "-";
}

std::string text(const Interval& interval) {
  return fmt::format("{:.2f}-{:.2f}", interval.low, interval.high);
}

std::string stem_of(const SuiteResult& result) { return std::filesystem::path(result.suite).stem().string(); }

}  // namespace

bool is_success(const nlohmann::json& card) {
  return is_success(card.value("reached", false), card.value("collisions", 1));
}

std::vector<PlannerSummary> summarize(const SuiteResult& result) {
  std::vector<PlannerSummary> planners;
  for (const auto& [planner, drives] : by_planner(result)) planners.push_back(summary_of(planner, drives));
  return planners;
}

nlohmann::json to_json(const SuiteResult& result, const std::vector<PlannerSummary>& planners) {
  nlohmann::json episodes = nlohmann::json::array();
  for (const EpisodeResult& drive : result.episodes) {
    nlohmann::json episode = drive.card;
    episode["planner_ms"] = episode["planner"];
    episode["name"] = drive.name;
    episode["seed"] = drive.seed;
    episode["planner"] = drive.planner;
    episode["success"] = drive.succeeded();
    episode["possible"] = !drive.is_excused();
    if (!drive.page.empty()) episode["page"] = drive.page;
    episode.erase("callbacks");
    if (drive.succeeded())
      episode.erase("robot_path");  // hundreds of drives in a file; failures are looked at
    episodes.push_back(std::move(episode));
  }
  nlohmann::json summary = nlohmann::json::object();
  for (const PlannerSummary& row : planners) summary[row.planner] = to_json(row);
  return {{"suite", result.suite},
          {"success_means", kSuccessMeans},
          {"summary", std::move(summary)},
          {"episodes", std::move(episodes)}};
}

std::string in_words(const std::vector<SuiteResult>& results,
                     const std::vector<std::vector<PlannerSummary>>& planners) {
  std::string out;
  for (const SuiteResult& result : results) {
    for (const EpisodeResult& drive : result.episodes) {
      if (drive.succeeded()) continue;
      out += "failed: " + in_a_line(drive) + (drive.is_excused() ? ", could not succeed" : "") + "\n" +
             contacts_in_words(drive.card, "  ");
    }
  }
  constexpr auto kRow =
      "{:<11} {:<13} {:>9} {:>11} {:>9} {:>11} {:>10} {:>8} {:>8} {:>8} {:>6} {:>6} {:>7} {:>5} {:>6} {:>6} {:>7} {:>7} {:>7}\n";
  out += fmt::format(kRow, "suite", "planner", "success", "Wilson 95 %", "possible", "Wilson 95 %",
                     "no contact", "contacts", "at speed", "person m", "CI max", "median", "time s", "jerk",
                     "pose m", "max", "ms mean", "p95", "max");
  std::string hits;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const std::string suite = stem_of(results[i]);
    for (const PlannerSummary& row : planners[i]) {
      out += fmt::format(kRow, suite, row.planner, fmt::format("{} of {}", row.successes, row.episodes),
                         text(row.wilson), fmt::format("{} of {}", row.successes, row.possible),
                         text(row.wilson_possible), row.reached_without_contact_at_speed, row.contacts,
                         row.contacts_at_speed, text(row.closest_person, 2), text(row.max_index, 2),
                         text(row.median_index, 2), text(row.mean_time, 1), text(row.mean_jerk, 2),
                         text(row.mean_pose, 3), text(row.max_pose, 2), text(row.mean_ms, 2),
                         text(row.p95_ms, 2), text(row.max_ms, 2));
      hits += fmt::format("contacts in {} of {}: {}\n", suite, row.planner, row.hits.in_words());
    }
  }
  return out + hits;
}

std::vector<ComparedRow> compared(const std::vector<SuiteResult>& results) {
  std::vector<ComparedRow> rows;
  for (const SuiteResult& result : results) {
    for (const auto& [planner, drives] : by_planner(result)) {
      auto row =
          std::find_if(rows.begin(), rows.end(), [&name = planner](const auto& r) { return r.name == name; });
      if (row == rows.end()) row = rows.insert(row, {planner, {}});
      for (const EpisodeResult* drive : drives) {
        constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
        const auto value = [&](const char* key) { return figure(drive->card, key).value_or(kUnknown); };
        row->episodes.push_back({.key = fmt::format("{} {} {}", result.suite, drive->name, drive->seed),
                                 .success = drive->succeeded(),
                                 .possible = !drive->is_excused(),
                                 .collision_index = value("max_collision_index"),
                                 .closest = value("closest_person_m"),
                                 .jerk = value("rms_jerk_mps3"),
                                 .time = value("time_to_goal_s")});
      }
    }
  }
  return rows;
}

nlohmann::json read_results(const std::filesystem::path& file, const std::string& label,
                            std::vector<SuiteResult>& results) {
  try {
    std::ifstream in(file);
    if (!in) throw std::runtime_error("cannot be read");
    const nlohmann::json root = nlohmann::json::parse(in);
    const nlohmann::json suites = root.contains("suites") ? root.at("suites") : nlohmann::json::array({root});
    for (const nlohmann::json& suite : suites) {
      const std::string name = suite.at("suite").get<std::string>();
      auto result =
          std::find_if(results.begin(), results.end(), [&](const auto& r) { return r.suite == name; });
      if (result == results.end()) result = results.insert(result, {name, {}});
      for (const nlohmann::json& episode : suite.at("episodes")) {
        EpisodeResult drive{episode.at("name").get<std::string>(), episode.at("seed").get<std::int64_t>(),
                            episode.at("planner").get<std::string>() + (label.empty() ? "" : " " + label),
                            episode};
        drive.card["planner"] = episode.at("planner_ms");
        result->episodes.push_back(std::move(drive));
      }
    }
    return root;
  } catch (const std::exception& error) {
    throw std::runtime_error(file.string() + ": holds no drives of `evaluate --json`: " + error.what());
  }
}

std::string in_a_line(const EpisodeResult& result) {
  const nlohmann::json& card = result.card;
  const std::string outcome = card.value("reached", false)
                                  ? "reached in " + text(figure(card, "time_to_goal_s"), 1) + " s"
                                  : "not reached (" + card.value("reason", "") + ")";
  return fmt::format("{} seed {} {}: {}, {} contacts ({} at speed), gap {} m, CI {}", result.name,
                     result.seed, result.planner, outcome, card.value("collisions", 0),
                     card.value("collisions_at_speed", 0), text(figure(card, "min_distance_m"), 2),
                     text(figure(card, "max_collision_index"), 2)) +
         (result.page.empty() ? "" : ", " + result.page);
}

}  // namespace bw
