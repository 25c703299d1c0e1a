// Many drives as one result: per planner how many succeeded (components/evaluation/success.hpp), and the
// figures of all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "components/evaluation/success.hpp"
#include "components/lab/comparison/comparison_report.hpp"
#include "components/lab/comparison/rate_interval.hpp"
#include "components/program/contacts/contact_report.hpp"

namespace bw {

/// Of a score card.
bool is_success(const nlohmann::json& card);

/// On the card of a drive that ended by a mistake of the program or of a planner process, and was not judged: it counts
/// as failed, and as the exit status 1.
inline constexpr const char* kRunFailed = "run_failed";

/// One drive: name, seed, planner (and the condition it drove under), and its score card
/// (score_card_json.hpp).
struct EpisodeResult {
  std::string name;
  std::int64_t seed = 0;
  std::string planner;
  nlohmann::json card;
  std::string page = {};  ///< file that plays the drive; empty: none

  bool succeeded() const { return bw::is_success(card); }
  bool run_failed() const { return card.value(kRunFailed, false); }
  /// It failed, and success was impossible for people who walk as they did (possible/theory.md 8.10).
  bool is_excused() const { return !succeeded() && !card.value("possible", true); }
};

/// The drives of one suite.
struct SuiteResult {
  std::string suite;  ///< its file
  std::vector<EpisodeResult> episodes;
};

/// The figures of one planner over a suite: reckoned once, for words, JSON and exit status. Nothing where no
/// drive has the figure.
struct PlannerSummary {
  std::string planner;
  int episodes = 0, reached = 0, successes = 0;
  Interval wilson;
  int reached_without_contact_at_speed = 0;
  int possible = 0;          ///< episodes in which success was possible (possible/theory.md 8.10)
  Interval wilson_possible;  ///< of the successes among them
  HitCounts hits;            ///< contacts with somebody by who hit whom
  std::int64_t contacts = 0, contacts_at_speed = 0;
  std::optional<double> min_distance, closest_person;  ///< [m]
  std::optional<double> max_index, median_index;
  std::optional<double> mean_time;                ///< [s] of the goals that were reached
  std::optional<double> mean_jerk;                ///< [m/s^3] of all drives
  std::optional<double> mean_pose, max_pose;      ///< error of the robot's position, rms and largest [m]
  std::optional<double> mean_ms, p95_ms, max_ms;  ///< of the planner; p95 is that of the worst drive
};

/// Planners in the order of their first drives.
std::vector<PlannerSummary> summarize(const SuiteResult& result);

/// Of one suite; the verb adds {planned, driven, complete}, which count drives:
/// {suite, success_means, summary: {planner: {episodes, reached, reached_without_contact_at_speed, successes,
/// wilson95, possible, wilson95_possible, hits, contacts, contacts_at_speed, min_distance_m,
/// closest_person_m, max_collision_index: {max, median}, mean_time_s, mean_rms_jerk_mps3, localization:
/// {mean_rms_m, max_m}, planner_ms: {mean, p95, max}}}, episodes: [{name, seed, planner, success, possible,
/// ... score card}]}. The robot's path is told of drives that failed, and their `page` where there is one.
nlohmann::json to_json(const SuiteResult& result, const std::vector<PlannerSummary>& planners);

/// The drives that failed with their contacts, and one table: a row for each suite and planner. Below it who
/// hit whom. `planners`: of each of the results.
std::string in_words(const std::vector<SuiteResult>& results,
                     const std::vector<std::vector<PlannerSummary>>& planners);

/// The drives of some suites by planner, for a comparison: the same episode of a suite with the same seed is
/// one pair.
std::vector<ComparedRow> compared(const std::vector<SuiteResult>& results);

/// The drives of a file that to_json() wrote, of one suite or several; `label`, where there is one, is put
/// behind each planner's name.
/// Returns all that the file holds. Throws std::runtime_error naming the file when it holds none.
nlohmann::json read_results(const std::filesystem::path& file, const std::string& label,
                            std::vector<SuiteResult>& results);

/// One drive on one line.
std::string in_a_line(const EpisodeResult& result);

}  // namespace bw
