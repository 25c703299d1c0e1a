#include "components/program/suite_report.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "components/local_planner/bench/bench_common.hpp"

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

std::int64_t total(const std::vector<const EpisodeResult*>& drives, const char* key) {
  std::int64_t sum = 0;
  for (const EpisodeResult* drive : drives) sum += drive->card.value(key, std::int64_t{0});
  return sum;
}

nlohmann::json summary(const std::vector<const EpisodeResult*>& drives) {
  std::vector<const EpisodeResult*> reached;
  int successes = 0;
  for (const EpisodeResult* drive : drives) {
    if (drive->card.value("reached", false)) reached.push_back(drive);
    if (drive->succeeded()) ++successes;
  }
  const Interval wilson = wilson95(successes, static_cast<int>(drives.size()));
  const std::vector<double> index = figures(drives, "max_collision_index");
  return {{"episodes", drives.size()},
          {"reached", reached.size()},
          {"successes", successes},
          {"wilson95", {wilson.low, wilson.high}},
          {"contacts", total(drives, "collisions")},
          {"contacts_at_speed", total(drives, "collisions_at_speed")},
          {"min_distance_m", smallest(figures(drives, "min_distance_m"))},
          {"max_collision_index", {{"max", largest(index)}, {"median", quantile(index, 0.5)}}},
          {"mean_time_s", mean(figures(reached, "time_to_goal_s"))},
          {"mean_rms_jerk_mps3", mean(figures(drives, "rms_jerk_mps3"))}};
}

std::string text(const nlohmann::json& value, int digits) {
  return value.is_number() ? fmt::format("{:.{}f}", value.get<double>(), digits) : "-";
}

}  // namespace

bool EpisodeResult::succeeded() const {
  return card.value("reached", false) && card.value("collisions_at_speed", 1) == 0;
}

nlohmann::json suite_json(const std::string& suite, const std::vector<EpisodeResult>& results) {
  std::map<std::string, std::vector<const EpisodeResult*>> by_planner;
  nlohmann::json episodes = nlohmann::json::array();
  for (const EpisodeResult& result : results) {
    by_planner[result.planner].push_back(&result);
    nlohmann::json episode = result.card;
    episode["planner_ms"] = episode["planner"];
    episode["name"] = result.name;
    episode["seed"] = result.seed;
    episode["planner"] = result.planner;
    episode["success"] = result.succeeded();
    episode.erase("callbacks");
    episodes.push_back(std::move(episode));
  }
  nlohmann::json planners = nlohmann::json::object();
  for (const auto& [planner, drives] : by_planner) planners[planner] = summary(drives);
  return {{"suite", suite}, {"summary", std::move(planners)}, {"episodes", std::move(episodes)}};
}

std::string in_words(const nlohmann::json& suite, const std::vector<EpisodeResult>& results) {
  std::string out;
  for (const EpisodeResult& result : results) {
    if (!result.succeeded()) out += "failed: " + in_a_line(result) + "\n";
  }
  out += fmt::format("{:<8} {:>9} {:>13} {:>9} {:>9} {:>8} {:>7} {:>7} {:>7} {:>8}\n", "planner", "success",
                     "Wilson 95 %", "contacts", "at speed", "gap m", "CI max", "median", "time s", "jerk");
  for (const auto& [planner, row] : suite["summary"].items()) {
    out += fmt::format("{:<8} {:>9} {:>13} {:>9} {:>9} {:>8} {:>7} {:>7} {:>7} {:>8}\n", planner,
                       fmt::format("{} of {}", row["successes"].get<int>(), row["episodes"].get<int>()),
                       text(row["wilson95"][0], 2) + " - " + text(row["wilson95"][1], 2),
                       row["contacts"].get<int>(), row["contacts_at_speed"].get<int>(),
                       text(row["min_distance_m"], 2), text(row["max_collision_index"]["max"], 2),
                       text(row["max_collision_index"]["median"], 2), text(row["mean_time_s"], 1),
                       text(row["mean_rms_jerk_mps3"], 2));
  }
  return out;
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
                     text(card.value("max_collision_index", nlohmann::json()), 2));
}

}  // namespace bw
