#include "components/lab/experiments/published_values.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "components/lab/experiments/edwa_scenes.hpp"

namespace bw {
namespace {

template <class Items, class Figure>
Spread spread_over(const Items& items, Figure figure) {
  std::vector<double> values;
  for (const auto& item : items) values.push_back(figure(item));
  return spread_of(values);
}

double mean_of(const EkfErrors& errors) { return errors.mean; }
double variance_of(const EkfErrors& errors) { return errors.variance; }
double square_of(const EkfErrors& errors) { return errors.rms * errors.rms; }

Spread speed_of(const EdwaRow& row) {
  std::vector<double> values;
  for (const EdwaRun& run : row.runs)
    if (run.outcome == FloorOutcome::reached) values.push_back(run.mean_speed);
  return spread_of(values);
}

const CrossingResult* find(const std::vector<CrossingResult>& results, const std::string& label) {
  const auto found =
      std::ranges::find_if(results, [&](const CrossingResult& r) { return r.entry.label == label; });
  return found == results.end() ? nullptr : &*found;
}

Spread behind_of(const CrossingResult& result) {
  const auto behind = std::ranges::count_if(
      result.runs, [](const CrossingRun& run) { return run.passing_a == Passing::behind; });
  return share_of(static_cast<std::size_t>(behind), result.runs.size());
}

Spread index_of(const std::vector<HallwayDrive>& drives, const std::string& planner, const char* episode) {
  std::vector<double> values;
  for (const HallwayDrive& drive : drives)
    if (drive.planner == planner && drive.episode == episode && drive.people_react && !drive.own_senses)
      values.push_back(drive.max_collision_index);
  return spread_of(values);
}

std::string in_capitals(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

constexpr const char* kAsPublished = "as published";

void add_crossing(std::vector<PublishedValue>& values, const AnticipationResults& results,
                  const std::string& planner) {
  const CrossingResult* by_default = find(results.crossing, planner);
  if (by_default == nullptr) return;
  PublishedValue value{planner == "eteb" ? "Figure 3.11" : "Figure 3.7",
                       in_capitals(planner) + ": share of runs that pass behind the left person", "",
                       planner == "teb" ? "in front" : "behind", behind_of(*by_default)};
  if (const CrossingResult* published = find(results.crossing, planner + ", published"))
    value.others.push_back({kAsPublished, behind_of(*published)});
  values.push_back(std::move(value));
}

void add_hallway(std::vector<PublishedValue>& values, const AnticipationResults& results,
                 const std::string& planner, const char* episode) {
  PublishedValue value{
      planner == "eteb" ? "Figure 3.12" : "Figure 3.9",
      fmt::format("{}, hallway {}: largest collision index of a drive", in_capitals(planner), episode), "",
      planner == "teb" ? "above 0.54" : "below 0.54", index_of(results.hallway, planner, episode)};
  const Spread published = index_of(results.hallway, planner + ", published", episode);
  if (published.count > 0) value.others.push_back({kAsPublished, published});
  values.push_back(std::move(value));
}

}  // namespace

std::vector<PublishedValue> published_values(const EkfReport& report) {
  std::vector<PublishedValue> values;
  for (const EkfRow& row : report.rows) {
    if (row.noise != EkfWheelNoise::placed) continue;
    const auto matched = std::ranges::find_if(report.rows, [&](const EkfRow& other) {
      return other.noise == EkfWheelNoise::matched && other.path == row.path &&
             other.sensors.name == row.sensors.name;
    });
    const auto w = static_cast<std::size_t>(row.path);
    const std::string what = fmt::format("{}, {}: ", to_string(row.path), row.sensors.name);
    values.push_back({"Figure 2.3", what + "mean error", "m",
                      fmt::format("{:.4f}", row.sensors.published_mean[w]), spread_over(row.runs, mean_of)});
    PublishedValue square{"Figure 2.3",
                          what + "variance of the error",
                          "m²",
                          fmt::format("{:.4f}", row.sensors.published_variance[w]),
                          spread_over(row.runs, variance_of),
                          {{"mean square, as it is called", spread_over(row.runs, square_of)}}};
    if (matched != report.rows.end()) {
      values.back().others.push_back({"filter that knows its wheels", spread_over(matched->runs, mean_of)});
      square.others.push_back({"filter that knows its wheels", spread_over(matched->runs, variance_of)});
    }
    values.push_back(std::move(square));
  }
  return values;
}

std::vector<PublishedValue> published_values(const PfTable& table) {
  std::vector<PublishedValue> values;
  const auto spread = [&](std::size_t row, PfMethod method) {
    return spread_of(table.cells[row].at(static_cast<std::size_t>(method)).errors);
  };
  for (std::size_t row = 0; row < kPfRows.size(); ++row) {
    const std::string what = std::string(kPfRows[row].name) + " under the roof: mean error ";
    values.push_back({"Table 2.1",
                      what + "of the encoder",
                      "m",
                      fmt::format("{:.4f}", kPfRows[row].published_encoder),
                      spread(row, PfMethod::encoder),
                      {{"wheels alone from the start", spread(row, PfMethod::dead_reckoning)}}});
    values.push_back({"Table 2.1",
                      what + "of the filter",
                      "m",
                      fmt::format("{:.4f}", kPfRows[row].published_proposed),
                      spread(row, PfMethod::gaussian),
                      {{"weights as printed, errors in sigma", spread(row, PfMethod::printed)},
                       {"weights as printed, errors as they are", spread(row, PfMethod::printed_unscaled)}}});
  }
  return values;
}

std::vector<PublishedValue> published_values(const std::vector<EdwaResult>& results) {
  std::vector<PublishedValue> values;
  const std::vector<EdwaRow>& rows = results.at(0).table.rows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    PublishedValue value{"Table 3.2",
                         fmt::format("{}, {}: average passing velocity", edwa_scene_name(rows[i].scene),
                                     to_string(rows[i].pairing)),
                         "m/s", fmt::format("{:.4f}", rows[i].published), speed_of(rows[i])};
    for (std::size_t other = 1; other < results.size(); ++other)
      value.others.push_back({results[other].variant.name, speed_of(results[other].table.rows.at(i))});
    values.push_back(std::move(value));
  }
  return values;
}

std::vector<PublishedValue> published_values(const AnticipationResults& results) {
  std::vector<PublishedValue> values;
  std::vector<std::string> planners = {"teb", "pteb"};
  if (results.subject == "eteb") planners.emplace_back("eteb");
  for (const std::string& planner : planners) add_crossing(values, results, planner);
  for (const char* episode : {"light", "full"})
    for (const std::string& planner : planners) add_hallway(values, results, planner, episode);
  return values;
}

}  // namespace bw
