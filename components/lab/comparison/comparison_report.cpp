#include "components/lab/comparison/comparison_report.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace bw {
namespace {

using Json = nlohmann::ordered_json;

RowFigures figures_of(const ComparedRow& row) {
  RowFigures figures;
  figures.name = row.name;
  std::vector<double> index, closest, jerk, time;
  for (const PairedEpisode& episode : row.episodes) {
    index.push_back(episode.collision_index);
    closest.push_back(episode.closest);
    jerk.push_back(episode.jerk);
    if (episode.success) time.push_back(episode.time);
    if (!episode.possible) continue;
    ++figures.possible;
    if (episode.collision_index <= kCalmIndex) ++figures.calm;
  }
  figures.collision_index = bootstrap_mean(index);
  figures.closest = bootstrap_mean(closest);
  figures.jerk = bootstrap_mean(jerk);
  figures.time = bootstrap_mean(time);
  figures.wilson = wilson95(figures.calm, figures.possible);
  return figures;
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json to_json(const MeanInterval& interval) {
  return {{"count", interval.count},
          {"mean", number(interval.mean)},
          {"low", number(interval.low)},
          {"high", number(interval.high)}};
}

std::string in_words(const MeanInterval& interval, int digits, bool is_difference) {
  if (interval.count == 0) return "-";
  const char* form = is_difference ? "{:+.{}f} ({:+.{}f} to {:+.{}f})" : "{:.{}f} ({:.{}f} to {:.{}f})";
  return fmt::format(fmt::runtime(form), interval.mean, digits, interval.low, digits, interval.high, digits);
}

int width_of(const std::vector<RowFigures>& rows) {
  std::size_t width = 14;
  for (const RowFigures& row : rows) width = std::max(width, row.name.size());
  return static_cast<int>(width);
}

}  // namespace

std::size_t row_against(const std::vector<ComparedRow>& rows, const std::string& against) {
  if (against.empty()) return 0;
  std::string known;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].name == against) return i;
    known += (i == 0 ? "" : ", ") + rows[i].name;
  }
  throw std::runtime_error("--against " + against + ": must be one of " + known);
}

ComparisonSummary summarize(const std::vector<ComparedRow>& rows, const std::string& against) {
  ComparisonSummary summary;
  for (const ComparedRow& row : rows) summary.rows.push_back(figures_of(row));
  if (rows.size() < 2) return summary;
  const ComparedRow& first = rows[row_against(rows, against)];
  summary.against = first.name;
  for (const ComparedRow& row : rows)
    if (&row != &first) summary.pairs.push_back({row.name, compare(first.episodes, row.episodes)});
  return summary;
}

Json to_json(const ComparisonSummary& summary) {
  Json json = {{"bootstrap", {{"samples", kBootstrapSamples}, {"seed", kBootstrapSeed}}},
               {"rows", Json::object()}};
  for (const RowFigures& row : summary.rows) {
    json["rows"][row.name] = {
        {"collision_index", to_json(row.collision_index)},
        {"closest_m", to_json(row.closest)},
        {"rms_jerk_mps3", to_json(row.jerk)},
        {"time_s", to_json(row.time)},
        {"calm",
         {{"count", row.calm}, {"of", row.possible}, {"wilson95", {row.wilson.low, row.wilson.high}}}}};
  }
  if (summary.rows.size() < 2) return json;
  json["against"] = summary.against;
  json["pairs"] = Json::object();
  for (const auto& [name, c] : summary.pairs) {
    json["pairs"][name] = {{"pairs", c.pairs},
                           {"only_this", c.only_second},
                           {"only_other", c.only_first},
                           {"mcnemar_p", c.p},
                           {"success", to_json(c.success)},
                           {"both", c.both},
                           {"collision_index", to_json(c.collision_index)},
                           {"closest_m", to_json(c.closest)},
                           {"rms_jerk_mps3", to_json(c.jerk)},
                           {"time_s", to_json(c.time)}};
  }
  return json;
}

std::string in_words(const ComparisonSummary& summary) {
  if (summary.rows.empty()) return "";
  const int width = width_of(summary.rows);
  constexpr auto kRow = "{:<{}} {:>24} {:>24} {:>24} {:>24}  {}\n";
  std::string out = fmt::format(kRow, "means (95 %)", width, "CI", "closest m", "jerk m/s^3", "time s",
                                fmt::format("CI <= {} where possible", kCalmIndex));
  for (const RowFigures& row : summary.rows) {
    out += fmt::format(
        kRow, row.name, width, in_words(row.collision_index, 3, false), in_words(row.closest, 3, false),
        in_words(row.jerk, 2, false), in_words(row.time, 2, false),
        fmt::format("{} of {} ({:.3f} - {:.3f})", row.calm, row.possible, row.wilson.low, row.wilson.high));
  }
  if (summary.rows.size() < 2) return out;
  out += fmt::format(kRow, "against " + summary.against, width, "CI", "closest m", "jerk m/s^3", "time s",
                     "pairs: succeeded only this, only " + summary.against + "; McNemar p; both; success");
  for (const auto& [name, c] : summary.pairs) {
    out += fmt::format(kRow, name, width, in_words(c.collision_index, 3, true), in_words(c.closest, 3, true),
                       in_words(c.jerk, 2, true), in_words(c.time, 2, true),
                       fmt::format("{}: {}, {}; {:.3f}; {}; {}", c.pairs, c.only_second, c.only_first, c.p,
                                   c.both, in_words(c.success, 3, true)));
  }
  return out +
         fmt::format("intervals by bootstrap of {} samples, seed {}\n", kBootstrapSamples, kBootstrapSeed);
}

}  // namespace bw
