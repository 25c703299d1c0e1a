// Means with their intervals, and each way of driving against one of them on the same episodes, as JSON for scripts and as tables
// (book 8.12).
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "components/evaluation/paired.hpp"

namespace bw {

/// A way of driving: a planner, or a planner under a condition.
struct ComparedRow {
  std::string name;
  std::vector<PairedEpisode> episodes;
};

/// Physical safety by book 7.7.
inline constexpr double kCalmIndex = 0.54;

/// Index of the row that the others are held against: that of the name, the first for an empty one. Throws std::runtime_error naming
/// the rows when there is none.
std::size_t row_against(const std::vector<ComparedRow>& rows, const std::string& against);

/// {bootstrap: {samples, seed}, rows: {name: {collision_index, closest_m, rms_jerk_mps3, time_s: {count, mean, low, high}, calm: {count, of,
/// wilson95}}}, against, pairs: {name: {pairs, only_this, only_other, mcnemar_p, success, both, collision_index, closest_m, rms_jerk_mps3, time_s}}}.
/// Figures of rows are of all episodes, time of those that succeeded; `calm`: index at most kCalmIndex, of the episodes in which success
/// was possible. Differences are this less the other one. `against` and `pairs` are there with two rows or more.
nlohmann::ordered_json comparison_json(const std::vector<ComparedRow>& rows, const std::string& against);

/// The same as two tables.
std::string comparison_in_words(const std::vector<ComparedRow>& rows, const std::string& against);

}  // namespace bw
