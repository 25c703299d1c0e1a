// What is told of a planner's drives whatever they were among: rates, who hit whom, jerk, times of a cycle.
// `bench crowd` and `bench crowdnav` add columns of their own.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "components/evaluation/judged_contact.hpp"
#include "components/lab/comparison/rate_interval.hpp"
#include "components/program/contacts/contact_report.hpp"

namespace bw {

/// One drive. Whoever is late has failed where success was possible, whatever its contacts: only a drive that
/// came to its end can be excused by them (possible/theory.md 8.10).
struct RatedDrive {
  std::string name;
  std::string outcome;  ///< a word for one that failed
  bool success = false;
  bool is_late = false;     ///< it did not arrive in time, without a contact
  bool is_excused = false;  ///< it failed, and success was impossible
  std::vector<JudgedContact> contacts;
  double rms_jerk = 0.0;   ///< [m/s^3]
  std::vector<double> ms;  ///< CPU time of every cycle
};

struct DriveRates {
  std::string planner;
  int episodes = 0, successes = 0, timeouts = 0;
  Interval wilson;
  int possible = 0;          ///< episodes in which success was possible
  Interval wilson_possible;  ///< of the successes among them
  HitCounts hits;
  double mean_rms_jerk = 0.0;
  double mean_ms = 0.0, p95_ms = 0.0, max_ms = 0.0;  ///< over all cycles

  double share(int count) const { return episodes > 0 ? static_cast<double>(count) / episodes : 0.0; }
};

DriveRates rates_of(const std::string& planner, const std::vector<RatedDrive>& drives);

/// {episodes, success_means, successes, wilson95, possible, wilson95_possible, hits, timeouts,
/// mean_rms_jerk_mps3, mean_ms, p95_ms, max_ms}.
nlohmann::ordered_json to_json(const DriveRates& rates);

/// {name, possible, contacts, rms_jerk_mps3, mean_ms, p95_ms, max_ms}.
nlohmann::ordered_json to_json(const RatedDrive& drive);

/// A column of one kind of drives: two lines of head, and what each planner has there.
struct OwnColumn {
  std::string head;
  std::string below;
  std::vector<std::string> cells;
};

/// One row per planner below a head, `own` in the middle, each with a cell for each planner; then who hit
/// whom.
std::string drive_table(const std::vector<DriveRates>& planners, const std::vector<OwnColumn>& own);

/// The drives that failed, each with its contacts and their verdicts; empty when none did.
std::string failures(const std::string& planner, const std::vector<RatedDrive>& drives);

}  // namespace bw
