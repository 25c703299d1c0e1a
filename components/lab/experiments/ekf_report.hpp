// What `bandwagon reproduce ekf` writes: E1 (Figure 2.3) with the published values beside it, and E7 on logs
// of real robots, as JSON and as a page.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "components/lab/experiments/criterion.hpp"
#include "components/lab/experiments/ekf_experiment.hpp"
#include "components/lab/experiments/localization_real_data.hpp"
#include "components/lab/report/document.hpp"

namespace bw {

inline constexpr int kEkfSeeds = 100;  ///< of E1; with fewer nothing of it is judged

/// One path and sensor set over all seeds.
struct EkfRow {
  EkfPath path = EkfPath::sinus;
  EkfWheelNoise noise = EkfWheelNoise::placed;
  EkfSensorSet sensors;
  std::vector<EkfErrors> runs;          ///< seeds 1 to n
  EkfErrors mean;                       ///< of each figure over the seeds
  std::vector<EkfSample> example = {};  ///< course of the first seed
};

struct EkfReport {
  int seeds = 0;
  std::vector<EkfRow> rows;  ///< placed, then matched; of each the sinus, then the circle
  std::optional<RealDataResults> real_data;
  std::string real_data_missing;  ///< why there is none
};

std::string_view to_string(EkfPath path);
std::string_view to_string(EkfWheelNoise noise);

std::vector<EkfRow> ekf_rows(int seeds);

/// Value of the mean errors that a share of the seeds stays below (nearest rank).
double quantile_of_means(const EkfRow& row, double share);

/// Of protocols.md 8.1, asked of the placed filter: (a) order and ratio, (b) published means, (c) fused
/// variances.
/// The encoders' published variance is unexplained and not asked for (d).
std::vector<Criterion> ekf_criteria(const std::vector<EkfRow>& rows);

/// E1's, and E7's where there is data.
std::vector<Criterion> all_criteria(const EkfReport& report);

/// {experiment, seeds, rows: [{way, wheel_noise, sensors, published_mean, ..., per_seed}], real_data: {...}
/// or a text why not, criteria: [{name, asked, measured, met}]}
nlohmann::ordered_json ekf_json(const EkfReport& report);

/// What the page shows.
report::Document ekf_page(const EkfReport& report);

}  // namespace bw
