#include "components/lab/experiments/ekf_report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/base/quantile.hpp"

namespace bw {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kRatio = 100.0;         // encoders / all sensors, protocols.md 8.1 (a)
constexpr double kMeanShare = 0.25;      // (b)
constexpr double kVarianceFactor = 3.0;  // (c)

const EkfRow& row_of(const std::vector<EkfRow>& rows, EkfPath path, EkfWheelNoise noise, std::size_t set) {
  return *std::find_if(rows.begin(), rows.end(), [&](const EkfRow& row) {
    return row.path == path && row.noise == noise && row.sensors.name == kEkfSensorSets[set].name;
  });
}

Json errors_json(const EkfErrors& errors) {
  return {{"mean_m", errors.mean}, {"variance_m2", errors.variance}, {"rms_m", errors.rms}};
}

Json real_data_json(const RealDataResults& results) {
  const RealDataParameters& p = results.parameters;
  Json json = {{"parameters",
                {{"wheel_noise_m", p.sensors.wheel_noise},
                 {"gyro_noise_rad_per_s", p.sensors.gyro_noise},
                 {"compass_noise_rad", p.sensors.compass_noise},
                 {"position_walk_m_per_sqrt_m", p.position_walk},
                 {"heading_offset_sigma_rad", p.heading_offset_sigma}}},
               {"seeds", results.seeds},
               {"logs", Json::array()},
               {"rows", Json::array()},
               {"position_walk", Json::array()}};
  for (const NamedLog& log : results.logs)
    json["logs"].push_back({{"name", log.name}, {"source", log.source}, {"licence", log.licence}});
  for (const RealDataRow& row : results.rows) {
    json["rows"].push_back({{"log", row.log},
                            {"task", row.task},
                            {"sensors", row.sensors},
                            {"reference_mean_m", row.reference},
                            {"mean_m", row.mean},
                            {"rms_m", row.rms},
                            {"largest_m", row.largest},
                            {"places", row.count},
                            {"first_pose_s", row.first_pose}});
  }
  for (const WalkRow& row : results.walks) {
    json["position_walk"].push_back({{"position_walk_m_per_sqrt_m", row.position_walk},
                                     {"husky_half_m", row.husky_half},
                                     {"husky_outage_m", row.husky_outage},
                                     {"mrclam_gps_m", row.mrclam_gps},
                                     {"mrclam_all_m", row.mrclam_all},
                                     {"labyrinth_m", row.labyrinth}});
  }
  return json;
}

}  // namespace

std::string_view to_string(EkfPath path) { return path == EkfPath::sinus ? "sinus" : "circle"; }
std::string_view to_string(EkfWheelNoise noise) {
  return noise == EkfWheelNoise::placed ? "placed" : "matched";
}

std::vector<EkfRow> ekf_rows(int seeds) {
  std::vector<EkfRow> rows;
  for (const EkfWheelNoise noise : {EkfWheelNoise::placed, EkfWheelNoise::matched}) {
    for (const EkfPath path : {EkfPath::sinus, EkfPath::circle}) {
      for (const EkfSensorSet& sensors : kEkfSensorSets) {
        EkfRow row{path, noise, sensors, run_ekf_experiments(path, sensors, noise, seeds), {}};
        row.example = drive_ekf(path, sensors, noise, 1);
        for (const EkfErrors& errors : row.runs) {
          row.mean.mean += errors.mean / seeds;
          row.mean.variance += errors.variance / seeds;
          row.mean.rms += errors.rms / seeds;
        }
        rows.push_back(std::move(row));
      }
    }
  }
  return rows;
}

double quantile_of_means(const EkfRow& row, double share) {
  std::vector<double> means;
  for (const EkfErrors& errors : row.runs) means.push_back(errors.mean);
  if (means.empty()) return std::numeric_limits<double>::quiet_NaN();
  return quantile(std::move(means), share);
}

std::vector<Criterion> ekf_criteria(const std::vector<EkfRow>& rows) {
  std::vector<Criterion> criteria;
  for (const EkfPath path : {EkfPath::sinus, EkfPath::circle}) {
    const std::string name(to_string(path));
    const auto w = static_cast<std::size_t>(path);
    const auto mean = [&](std::size_t set) { return row_of(rows, path, EkfWheelNoise::placed, set).mean; };
    const double ratio = mean(0).mean / mean(3).mean;
    criteria.push_back({name + ": (a) encoder / all", "> 100", ratio, ratio > kRatio});
    const double least = std::min(mean(1).mean, mean(2).mean) / mean(3).mean;
    criteria.push_back({name + ": (a) the better of + GPS and + compass / all", "> 1", least, least > 1.0});
    int placed = 0;
    double worst_factor = 1.0;
    for (std::size_t set = 0; set < kEkfSensorSets.size(); ++set) {
      const EkfRow& row = row_of(rows, path, EkfWheelNoise::placed, set);
      const double published = row.sensors.published_mean[w];
      const bool inside =
          published >= quantile_of_means(row, 0.01) && published <= quantile_of_means(row, 0.99);
      if (inside || std::abs(row.mean.mean - published) <= kMeanShare * published) ++placed;
      const double factor = row.mean.variance / row.sensors.published_variance[w];
      if (set > 0) worst_factor = std::max({worst_factor, factor, 1.0 / factor});
    }
    criteria.push_back({name + ": (b) published means within 1 to 99 % of the seeds, or the mean within 25 %",
                        "4 of 4", static_cast<double>(placed), placed == 4});
    criteria.push_back({name + ": (c) largest factor between fused and published variances", "<= 3",
                        worst_factor, worst_factor <= kVarianceFactor});
  }
  for (Criterion& c : criteria) c = over_seeds(std::move(c), rows.front().runs.size(), kEkfSeeds);
  return criteria;
}

std::vector<Criterion> all_criteria(const EkfReport& report) {
  std::vector<Criterion> criteria = ekf_criteria(report.rows);
  if (!report.real_data) return criteria;
  for (Criterion& c : real_data_criteria(*report.real_data)) criteria.push_back(std::move(c));
  return criteria;
}

nlohmann::ordered_json ekf_json(const EkfReport& report) {
  Json json = {{"experiment", "ekf"}, {"seeds", report.seeds}, {"rows", Json::array()}};
  for (const EkfRow& row : report.rows) {
    const auto w = static_cast<std::size_t>(row.path);
    Json per_seed = Json::array();
    for (const EkfErrors& errors : row.runs) per_seed.push_back(errors_json(errors));
    json["rows"].push_back({{"way", to_string(row.path)},
                            {"wheel_noise", to_string(row.noise)},
                            {"sensors", row.sensors.name},
                            {"published_mean_m", row.sensors.published_mean[w]},
                            {"published_variance_m2", row.sensors.published_variance[w]},
                            {"measured", errors_json(row.mean)},
                            {"mean_1_percent_m", quantile_of_means(row, 0.01)},
                            {"mean_99_percent_m", quantile_of_means(row, 0.99)},
                            {"per_seed", std::move(per_seed)}});
  }
  json["real_data"] = report.real_data ? real_data_json(*report.real_data) : Json(report.real_data_missing);
  json["criteria"] = criteria_json(all_criteria(report));
  return json;
}

}  // namespace bw
