#include "components/tools/evaluate/suite_report.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "components/tools/bench/bench_common.hpp"
#include "components/tools/contacts/contact_report.hpp"
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

nlohmann::json mean(const std::vector<double>& values) {
  if (values.empty()) return nullptr;
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

nlohmann::json largest(const std::vector<double>& values) {
  if (values.empty()) return nullptr;
  return *std::max_element(values.begin(), values.end());
}

nlohmann::json smallest(const std::vector<double>& values) {
  if (values.empty()) return nullptr;
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

nlohmann::json summary(const std::vector<const EpisodeResult*>& drives) {
  std::vector<const EpisodeResult*> reached;
  int successes = 0;
  int possible = 0;
  for (const EpisodeResult* drive : drives) {
    if (drive->card.value("reached", false)) reached.push_back(drive);
    if (drive->succeeded()) ++successes;
    if (!drive->is_excused()) ++possible;
  }
  const Interval wilson = wilson95(successes, static_cast<int>(drives.size()));
  const Interval where_possible = wilson95(successes, possible);
  const std::vector<double> index = figures(drives, "max_collision_index");
  return {{"episodes", drives.size()},
          {"reached", reached.size()},
          {"successes", successes},
          {"wilson95", {wilson.low, wilson.high}},
          {"possible", possible},
          {"wilson95_possible", {where_possible.low, where_possible.high}},
          {"hits", nlohmann::json(hits_of(drives).to_json())},
          {"contacts", total(drives, "collisions")},
          {"contacts_at_speed", total(drives, "collisions_at_speed")},
          {"min_distance_m", smallest(figures(drives, "min_distance_m"))},
          {"closest_person_m", smallest(figures(drives, "closest_person_m"))},
          {"max_collision_index", {{"max", largest(index)}, {"median", quantile(index, 0.5)}}},
          {"mean_time_s", mean(figures(reached, "time_to_goal_s"))},
          {"mean_rms_jerk_mps3", mean(figures(drives, "rms_jerk_mps3"))},
          {"localization",
           {{"mean_rms_m", mean(part_figures(drives, "localization", "rms_m"))},
            {"max_m", largest(part_figures(drives, "localization", "max_m"))}}},
          {"planner_ms",
           {{"mean", mean(part_figures(drives, "planner", "mean_ms"))},
            {"p95", largest(part_figures(drives, "planner", "p95_ms"))},
            {"max", largest(part_figures(drives, "planner", "max_ms"))}}}};
}

std::string text(const nlohmann::json& value, int digits) {
  return value.is_number() ? fmt::format("{:.{}f}", value.get<double>(), digits) : "-";
}

}  // namespace

bool EpisodeResult::succeeded() const {
  return card.value("reached", false) && card.value("collisions_at_speed", 1) == 0;
}

nlohmann::json to_json(const SuiteResult& result) {
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
  nlohmann::json planners = nlohmann::json::object();
  for (const auto& [planner, drives] : by_planner(result)) planners[planner] = summary(drives);
  return {{"suite", result.suite}, {"summary", std::move(planners)}, {"episodes", std::move(episodes)}};
}

std::string in_words(const std::vector<SuiteResult>& results) {
  std::string out;
  for (const SuiteResult& result : results) {
    for (const EpisodeResult& drive : result.episodes) {
      if (drive.succeeded()) continue;
      out += "failed: " + in_a_line(drive) + (drive.is_excused() ? ", could not succeed" : "") + "\n" +
             contacts_in_words(drive.card, "  ");
    }
  }
  constexpr auto kRow =
      "{:<11} {:<13} {:>9} {:>11} {:>9} {:>11} {:>8} {:>8} {:>8} {:>6} {:>6} {:>7} {:>5} {:>6} {:>6} {:>7} {:>7} {:>7}\n";
  out += fmt::format(kRow, "suite", "planner", "success", "Wilson 95 %", "possible", "Wilson 95 %",
                     "contacts", "at speed", "person m", "CI max", "median", "time s", "jerk", "pose m",
                     "max", "ms mean", "p95", "max");
  for (const SuiteResult& result : results) {
    for (const auto& [planner, drives] : by_planner(result)) {
      const nlohmann::json row = summary(drives);
      out += fmt::format(kRow, std::filesystem::path(result.suite).stem().string(), planner,
                         fmt::format("{} of {}", row["successes"].get<int>(), row["episodes"].get<int>()),
                         text(row["wilson95"][0], 2) + "-" + text(row["wilson95"][1], 2),
                         fmt::format("{} of {}", row["successes"].get<int>(), row["possible"].get<int>()),
                         text(row["wilson95_possible"][0], 2) + "-" + text(row["wilson95_possible"][1], 2),
                         row["contacts"].get<int>(), row["contacts_at_speed"].get<int>(),
                         text(row["closest_person_m"], 2), text(row["max_collision_index"]["max"], 2),
                         text(row["max_collision_index"]["median"], 2), text(row["mean_time_s"], 1),
                         text(row["mean_rms_jerk_mps3"], 2), text(row["localization"]["mean_rms_m"], 3),
                         text(row["localization"]["max_m"], 2), text(row["planner_ms"]["mean"], 2),
                         text(row["planner_ms"]["p95"], 2), text(row["planner_ms"]["max"], 2));
    }
  }
  for (const SuiteResult& result : results)
    for (const auto& [planner, drives] : by_planner(result))
      out += fmt::format("contacts in {} of {}: {}\n", std::filesystem::path(result.suite).stem().string(),
                         planner, hits_of(drives).in_words());
  return out;
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

void read_results(const std::filesystem::path& file, const std::string& label,
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
  } catch (const std::exception& error) {
    throw std::runtime_error(file.string() + ": holds no drives of `evaluate --json`: " + error.what());
  }
}

std::string in_a_line(const EpisodeResult& result) {
  const nlohmann::json& card = result.card;
  const std::string outcome =
      card.value("reached", false)
          ? "reached in " + text(card.value("time_to_goal_s", nlohmann::json()), 1) + " s"
          : "not reached (" + card.value("reason", "") + ")";
  return fmt::format("{} seed {} {}: {}, {} contacts ({} at speed), gap {} m, CI {}", result.name,
                     result.seed, result.planner, outcome, card.value("collisions", 0),
                     card.value("collisions_at_speed", 0),
                     text(card.value("min_distance_m", nlohmann::json()), 2),
                     text(card.value("max_collision_index", nlohmann::json()), 2)) +
         (result.page.empty() ? "" : ", " + result.page);
}

}  // namespace bw
