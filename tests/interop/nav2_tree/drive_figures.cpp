#include "tests/interop/nav2_tree/drive_figures.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace bw::test {
namespace {

constexpr int kAborted = 6;

/// The smallest value that at least this share does not exceed.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::ranges::sort(values);
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  return values[std::min(values.size() - 1, rank == 0 ? 0 : rank - 1)];
}

double mean(const std::vector<double>& values) {
  return values.empty()
             ? 0.0
             : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::string quantiles(const std::string& what, const std::vector<double>& values, double scale,
                      const std::string& unit) {
  return fmt::format("{}: {} of them, p50 {:.3f}, p95 {:.3f}, p99.9 {:.3f}, largest {:.3f} {}\n", what,
                     values.size(), scale * quantile(values, 0.5), scale * quantile(values, 0.95),
                     scale * quantile(values, 0.999), scale * quantile(values, 1.0), unit);
}

void append(std::vector<double>& all, const nlohmann::json& more) {
  for (const auto& value : more) all.push_back(value.get<double>());
}

}  // namespace

std::string DriveFigures::add(int seed, const DriveReport& report) {
  const auto& tree = report.tree;
  double slowest = 0.0;
  for (const auto& exchange : tree["exchanges"]) {
    const double took = exchange["took"].get<double>();
    const bool is_clear = exchange["what"].get<std::string>().find("/clear") != std::string::npos;
    if (took < 0.0) {
      ++unanswered_;
    } else {
      (is_clear ? clears_ : acknowledgements_).push_back(took);
      slowest = std::max(slowest, took);
    }
  }
  for (const auto& end : tree["ends"])
    replaced_otherwise_ += end["was_replaced"].get<bool>() && end["status"] != kAborted ? 1 : 0;
  append(dips_, tree["dips"]);
  append(dips_in_between_, tree["dips_in_between"]);
  if (tree.contains("pose_age_max")) pose_ages_.push_back(tree["pose_age_max"].get<double>());
  times_.push_back(tree["time"].get<double>());
  recoveries_ += tree["recoveries"].get<int>();
  contacts_ += report.card["collisions"].get<int>();
  return fmt::format(
      "seed {}: {} after {:.1f} s, {:.2f} m from the goal, {} recoveries, {} contacts ({} at speed), "
      "nearest person {:.2f} m, "
      "{} preemptions, slowest answer {:.1f} ms {}",
      seed, tree["outcome"].get<std::string>(), times_.back(), report.left, tree["recoveries"].get<int>(),
      report.card["collisions"].get<int>(), report.card["collisions_at_speed"].get<int>(),
      report.card["closest_person_m"].is_number() ? report.card["closest_person_m"].get<double>() : INFINITY,
      tree["preemptions"].size(), 1e3 * slowest, tree["troubles"].dump());
}

double DriveFigures::added_dip() const { return mean(dips_) - mean(dips_in_between_); }

std::string DriveFigures::summary() const {
  return quantiles("acknowledgements", acknowledgements_, 1e3, "ms") +
         quantiles("clear services", clears_, 1e3, "ms") +
         fmt::format("without an answer in 20 ms: {}\n", unanswered_) +
         quantiles("dips at a new path", dips_, 1.0, "m/s") +
         quantiles("dips half a second later", dips_in_between_, 1.0, "m/s") +
         fmt::format("what a new path adds: {:.4f} m/s on average\n", added_dip()) +
         quantiles("oldest pose of a drive", pose_ages_, 1e3, "ms") + quantiles("times", times_, 1.0, "s") +
         fmt::format("recoveries {}, contacts {}\n", recoveries_, contacts_);
}

}  // namespace bw::test
