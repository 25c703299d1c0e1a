// Means with their intervals, and each way of driving against one of them on the same episodes, as JSON for
// scripts and as tables (evaluation/theory.md 8.12).
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "components/lab/comparison/paired.hpp"
#include "components/lab/comparison/rate_interval.hpp"

namespace bw {

/// A way of driving: a planner, or a planner under a condition.
struct ComparedRow {
  std::string name;
  std::vector<PairedEpisode> episodes;
};

/// Physical safety by evaluation/theory.md 7.7.
inline constexpr double kCalmIndex = 0.54;

/// Index of the row that the others are held against: that of the name, the first for an empty one. Throws
/// std::runtime_error naming the rows when there is none.
std::size_t row_against(const std::vector<ComparedRow>& rows, const std::string& against);

/// What is told of one row. Figures are of all episodes, time of those that succeeded.
struct RowFigures {
  std::string name;
  MeanInterval collision_index, closest, jerk, time;
  int calm = 0;      ///< index at most kCalmIndex, of the episodes in which success was possible
  int possible = 0;  ///< those
  Interval wilson;   ///< of the calm among them
};

/// What is told of one row against another; differences are this one less the other.
struct PairFigures {
  std::string name;
  Comparison figures;
};

/// Means, intervals and pairs of some rows: reckoned once, for words and for JSON.
struct ComparisonSummary {
  std::vector<RowFigures> rows;
  std::string against;             ///< the row that the others are held against; empty with fewer than two
  std::vector<PairFigures> pairs;  ///< of all the others, in their order
};

/// `against` as for row_against().
ComparisonSummary summarize(const std::vector<ComparedRow>& rows, const std::string& against);

/// {bootstrap: {samples, seed}, rows: {name: {collision_index, closest_m, rms_jerk_mps3, time_s: {count,
/// mean, low, high}, calm: {count, of, wilson95}}}, against, pairs: {name: {pairs, only_this, only_other,
/// mcnemar_p, success, both, collision_index, closest_m, rms_jerk_mps3, time_s}}}. `against` and `pairs` are
/// there with two rows or more.
nlohmann::ordered_json to_json(const ComparisonSummary& summary);

/// The same as two tables; empty without a row.
std::string in_words(const ComparisonSummary& summary);

}  // namespace bw
