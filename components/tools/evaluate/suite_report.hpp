// Many drives as one result: per planner how many succeeded, and the figures of all. A drive succeeds when
// the goal is reached and nobody was touched while the robot moved (collisions_at_speed is 0): people who do
// not see the robot may walk into one that stands.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "components/tools/comparison/comparison_report.hpp"

namespace bw {

/// One drive: name, seed, planner (and the condition it drove under), and its score card (score_card_json.hpp).
struct EpisodeResult {
  std::string name;
  std::int64_t seed = 0;
  std::string planner;
  nlohmann::json card;
  std::string page = {};  ///< file that plays the drive; empty: none

  bool succeeded() const;
  /// It failed, and success was impossible for people who walk as they did (book 8.10).
  bool is_excused() const { return !succeeded() && !card.value("possible", true); }
};

/// The drives of one suite.
struct SuiteResult {
  std::string suite;  ///< its file
  std::vector<EpisodeResult> episodes;
};

/// Of one suite; the verb adds {planned, driven, complete}, which count drives:
/// {suite, summary: {planner: {episodes, reached, successes, wilson95, possible, wilson95_possible, hits, contacts, contacts_at_speed,
/// min_distance_m, closest_person_m, max_collision_index: {max, median}, mean_time_s, mean_rms_jerk_mps3,
/// localization: {mean_rms_m, max_m}, planner_ms: {mean, p95, max}}}, episodes: [{name, seed, planner,
/// success, possible, ... score card}]}. `possible`: episodes in which success was possible; `hits`: contacts with somebody by who
/// hit whom (contact_report.hpp). Times and jerk are means over reached goals and over all drives; p95 of the
/// planner's time is that of the worst drive. The robot's way is told of drives that failed, and their `page` where there is one.
nlohmann::json to_json(const SuiteResult& result);

/// The drives that failed with their contacts, and one table: a row for each suite and planner, planners in the order they were
/// driven. Below it who hit whom.
std::string in_words(const std::vector<SuiteResult>& results);

/// The drives of some suites by planner, for a comparison: the same episode of a suite with the same seed is one pair.
std::vector<ComparedRow> compared(const std::vector<SuiteResult>& results);

/// The drives of a file that to_json() wrote, of one suite or several; `label`, where there is one, is put behind each planner's name.
/// Throws std::runtime_error naming the file when it holds none.
void read_results(const std::filesystem::path& file, const std::string& label,
                  std::vector<SuiteResult>& results);

/// One drive on one line.
std::string in_a_line(const EpisodeResult& result);

}  // namespace bw
