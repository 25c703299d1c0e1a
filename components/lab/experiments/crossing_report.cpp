#include "components/lab/experiments/crossing_report.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace bw {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMoreOften = 0.2;

const CrossingResult& result_of(const std::vector<CrossingResult>& results, const std::string& label) {
  const auto found = std::find_if(results.begin(), results.end(),
                                  [&](const CrossingResult& r) { return r.entry.label == label; });
  if (found == results.end()) throw std::out_of_range("no row of " + label);
  return *found;
}

Json runs_json(const std::vector<CrossingRun>& runs) {
  Json list = Json::array();
  for (const CrossingRun& run : runs) {
    list.push_back({{"seed", run.seed},
                    {"passing_a", name_of(run.passing_a)},
                    {"passing_b", name_of(run.passing_b)},
                    {"success", run.episode.success},
                    {"contact", run.episode.collision},
                    {"time_s", run.episode.time},
                    {"min_clearance_m", run.episode.min_clearance},
                    {"max_collision_index", run.episode.max_collision_index},
                    {"rms_jerk_mps3", run.episode.rms_jerk}});
  }
  return list;
}

}  // namespace

std::vector<CrossingEntry> default_entries(bool with_eteb) {
  std::vector<CrossingEntry> entries = {
      {"teb", "teb", {}}, {"teb_homotopy", "teb_homotopy", {}}, {"pteb", "pteb", {}}};
  if (with_eteb) entries.push_back({"eteb", "eteb", {}});
  return entries;
}

std::vector<CrossingEntry> published_entries(bool with_eteb) {
  const std::vector<std::string> standing = {"teb.include_dynamic_obstacles=false",
                                             "homotopy.mover_topology=present"};
  std::vector<CrossingEntry> entries = {{"teb, published", "teb", standing},
                                        {"teb_homotopy, published", "teb_homotopy", standing},
                                        {"pteb, published", "pteb", standing}};
  if (with_eteb) {
    entries.push_back(
        {"eteb, published", "eteb", {"eteb.prediction=doubled", "homotopy.mover_topology=capsule"}});
  }
  return entries;
}

std::vector<Criterion> crossing_criteria(const std::vector<CrossingResult>& results,
                                         const std::string& planner, const std::string& reference) {
  const CrossingSummary own = summarize(result_of(results, planner));
  const CrossingSummary other = summarize(result_of(results, reference));
  const double more_often = own.share_behind_a - other.share_behind_a;
  const double index = own.mean_max_collision_index - other.mean_max_collision_index;
  const auto of_means = [&](Criterion c) {
    return over_seeds(std::move(c), static_cast<std::size_t>(own.runs), kCrossingRuns);
  };
  // Shares are sums of 1/40: equal to the bound must count as reached.
  return {of_means({planner + ": share that passes behind A above that of " + reference,
                    fmt::format(">= {}", kMoreOften), more_often, more_often >= kMoreOften - 1e-9}),
          {planner + ": runs with a contact", "0", static_cast<double>(own.contacts), own.contacts == 0},
          of_means({planner + ": mean of the largest collision index above that of " + reference, "< 0",
                    index, index < 0.0})};
}

nlohmann::ordered_json crossing_json(const CrossingGeometry& geometry,
                                     const std::vector<CrossingResult>& results) {
  Json rows = Json::array();
  for (const CrossingResult& result : results) {
    const CrossingSummary s = summarize(result);
    rows.push_back({{"label", result.entry.label},
                    {"planner", result.entry.planner},
                    {"set", result.entry.set},
                    {"runs", s.runs},
                    {"successes", s.successes},
                    {"contacts", s.contacts},
                    {"share_behind_a", s.share_behind_a},
                    {"share_behind_b", s.share_behind_b},
                    {"mean_max_collision_index", s.mean_max_collision_index},
                    {"max_collision_index", s.max_collision_index},
                    {"mean_time_s", s.mean_time},
                    {"mean_min_clearance_m", s.mean_min_clearance},
                    {"per_seed", runs_json(result.runs)}});
  }
  return {{"geometry", {{"a", {geometry.a.x(), geometry.a.y()}}, {"b", {geometry.b.x(), geometry.b.y()}}}},
          {"rows", std::move(rows)}};
}

std::string crossing_table(const std::vector<CrossingResult>& results) {
  std::string out = fmt::format("{:<24} {:>9} {:>9} {:>10} {:>10} {:>13} {:>7}\n", "people crossing",
                                "success", "contacts", "behind A", "behind B", "CI mean / max", "time s");
  for (const CrossingResult& result : results) {
    const CrossingSummary s = summarize(result);
    out += fmt::format(
        "{:<24} {:>9} {:>9} {:>10.3f} {:>10.3f} {:>13} {:>7.2f}\n", result.entry.label,
        fmt::format("{} of {}", s.successes, s.runs), s.contacts, s.share_behind_a, s.share_behind_b,
        fmt::format("{:.3f} / {:.3f}", s.mean_max_collision_index, s.max_collision_index), s.mean_time);
  }
  return out;
}

}  // namespace bw
