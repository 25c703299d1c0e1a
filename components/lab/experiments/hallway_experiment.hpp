// Experiment E6 (protocols.md 8.6, Figures 3.8b, 3.9, 3.12): a robot in a hallway among walkers, once by
// ideal senses (planners are compared, not what they are told), once by its own: localization, people and
// obstacles from sensors. The drives are those of a suite in lock-step; here is what is made of their score
// cards.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "components/evaluation/success.hpp"
#include "components/lab/experiments/criterion.hpp"
#include "runtime/base/pose2.hpp"

namespace bw {

inline constexpr int kHallwaySeeds = 20;  ///< of a row that is judged

/// One drive, from its score card (components/program/score_card_json.hpp).
struct HallwayDrive {
  std::string planner;  ///< label of the row
  std::string episode;  ///< light or full
  bool people_react = true;
  bool own_senses = false;  ///< otherwise pose, people and walls are told without error
  std::int64_t seed = 0;
  bool reached = false;
  int contacts = 0;
  int contacts_at_speed = 0;
  double max_collision_index = 0.0;
  double share_above_0_54 = 0.0;  ///< of the time
  double share_above_0_14 = 0.0;
  double time = 0.0;                 ///< [s] of the drive
  double path_length = 0.0;          ///< [m]
  std::vector<Vector2> course = {};  ///< collision index over time [s], of index_course(); empty: not kept
  std::string page = {};             ///< that plays the drive, beside the results; empty: none

  const char* senses() const { return own_senses ? "own" : "ideal"; }
  bool succeeded() const { return is_success(reached, contacts); }
};

/// Missing or null figures stay 0; a drive without a score card has not reached.
HallwayDrive hallway_drive(const std::string& planner, const std::string& episode, bool people_react,
                           std::int64_t seed, const nlohmann::json& card);

/// All seeds of one planner in one setting.
struct HallwayRow {
  std::string planner;
  std::string episode;
  bool people_react = true;
  bool own_senses = false;
  int drives = 0, successes = 0, reached = 0, contacts = 0, contacts_at_speed = 0;
  double median_max_collision_index = 0.0;
  double share_of_seeds_below_0_54 = 0.0;
  double mean_share_above_0_54 = 0.0, mean_share_above_0_14 = 0.0;  ///< of the time
  std::optional<double> mean_time, mean_path_length;                ///< of drives that reached
};

/// In the order in which planner and setting first appear.
std::vector<HallwayRow> hallway_rows(const std::vector<HallwayDrive>& drives);

/// By ideal senses, where people react, for every episode: the median max CI of the planners in `order` does
/// not rise from one to the next, and those after the first stay below 0.54 in at least 80 % of the seeds. Of
/// people who do not react, and of drives by own senses, the rows are only reported.
std::vector<Criterion> hallway_criteria(const std::vector<HallwayRow>& rows,
                                        const std::vector<std::string>& order);

/// {rows: [...], drives: [...]}
nlohmann::ordered_json hallway_json(const std::vector<HallwayDrive>& drives);

/// One line per row below a head.
std::string hallway_table(const std::vector<HallwayRow>& rows);

}  // namespace bw
