#include "components/lab/bench/drive_rates.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "components/evaluation/success.hpp"
#include "components/lab/bench/bench_common.hpp"
#include "runtime/base/quantile.hpp"

namespace bw {
namespace {

using Json = nlohmann::ordered_json;

std::string in_words(const Interval& i) { return fmt::format("{:.3f} - {:.3f}", i.low, i.high); }

/// Columns as wide as they need be, the first to the left.
class Table {
 public:
  explicit Table(std::size_t planners) : lines_(planners + 2) {}

  void add(const OwnColumn& column) {
    std::size_t width = std::max(column.head.size(), column.below.size());
    for (const std::string& cell : column.cells) width = std::max(width, cell.size());
    const bool is_first = lines_[0].empty();
    const auto put = [&](std::string& line, const std::string& text) {
      line += is_first ? fmt::format("{:<{}}", text, width) : fmt::format("  {:>{}}", text, width);
    };
    put(lines_[0], column.head);
    put(lines_[1], column.below);
    for (std::size_t i = 2; i < lines_.size(); ++i) put(lines_[i], column.cells[i - 2]);
  }

  std::string text() const {
    std::string out;
    for (const std::string& line : lines_) out += line + "\n";
    return out;
  }

 private:
  std::vector<std::string> lines_;
};

}  // namespace

DriveRates rates_of(const std::string& planner, const std::vector<RatedDrive>& drives) {
  DriveRates rates;
  rates.planner = planner;
  rates.episodes = static_cast<int>(drives.size());
  std::vector<double> jerks, ms;
  for (const RatedDrive& drive : drives) {
    rates.successes += drive.success ? 1 : 0;
    rates.timeouts += drive.is_late ? 1 : 0;
    rates.possible += drive.is_excused ? 0 : 1;
    for (const JudgedContact& contact : drive.contacts) rates.hits.add(contact.record);
    jerks.push_back(drive.rms_jerk);
    ms.insert(ms.end(), drive.ms.begin(), drive.ms.end());
  }
  rates.wilson = wilson95(rates.successes, rates.episodes);
  rates.wilson_possible = wilson95(rates.successes, rates.possible);
  rates.mean_rms_jerk = mean(jerks);
  rates.mean_ms = mean(ms);
  rates.p95_ms = quantile(ms, 0.95);
  rates.max_ms = quantile(ms, 1.0);
  return rates;
}

Json to_json(const DriveRates& rates) {
  return {{"episodes", rates.episodes},
          {"success_means", kSuccessMeans},
          {"successes", rates.successes},
          {"wilson95", {rates.wilson.low, rates.wilson.high}},
          {"possible", rates.possible},
          {"wilson95_possible", {rates.wilson_possible.low, rates.wilson_possible.high}},
          {"hits", rates.hits.to_json()},
          {"timeouts", rates.timeouts},
          {"mean_rms_jerk_mps3", rates.mean_rms_jerk},
          {"mean_ms", rates.mean_ms},
          {"p95_ms", rates.p95_ms},
          {"max_ms", rates.max_ms}};
}

Json to_json(const RatedDrive& drive) {
  return {{"name", drive.name},
          {"possible", !drive.is_excused},
          {"contacts", to_json(drive.contacts)},
          {"rms_jerk_mps3", drive.rms_jerk},
          {"mean_ms", mean(drive.ms)},
          {"p95_ms", quantile(drive.ms, 0.95)},
          {"max_ms", quantile(drive.ms, 1.0)}};
}

std::string drive_table(const std::vector<DriveRates>& planners, const std::vector<OwnColumn>& own) {
  Table table(planners.size());
  const auto add = [&](const char* head, const char* below, const auto& cell_of) {
    OwnColumn column{head, below, {}};
    for (const DriveRates& planner : planners) column.cells.push_back(cell_of(planner));
    table.add(column);
  };
  using Rates = const DriveRates&;
  add("planner", "", [](Rates r) { return r.planner; });
  add("success", "", [](Rates r) { return fmt::format("{} of {}", r.successes, r.episodes); });
  add("Wilson 95 %", "", [](Rates r) { return in_words(r.wilson); });
  add("possible", "", [](Rates r) { return fmt::format("{} of {}", r.successes, r.possible); });
  add("Wilson 95 %", "", [](Rates r) { return in_words(r.wilson_possible); });
  add("timeouts", "", [](Rates r) { return fmt::format("{}", r.timeouts); });
  for (const OwnColumn& column : own) table.add(column);
  add("jerk", "rms", [](Rates r) { return fmt::format("{:.2f}", r.mean_rms_jerk); });
  add("cycle ms", "mean / p95 / max",
      [](Rates r) { return fmt::format("{:.2f} / {:.2f} / {:.1f}", r.mean_ms, r.p95_ms, r.max_ms); });
  std::string out = table.text();
  for (const DriveRates& r : planners)
    out += fmt::format("contacts of {}: {}\n", r.planner, r.hits.in_words());
  return out;
}

std::string failures(const std::string& planner, const std::vector<RatedDrive>& drives) {
  std::string out;
  for (const RatedDrive& drive : drives) {
    if (drive.success) continue;
    out += fmt::format("failed: {} {}: {}{}\n", planner, drive.name, drive.outcome,
                       drive.is_excused ? ", could not succeed" : "");
    for (const Json& contact : to_json(drive.contacts)) out += "  " + contact_in_words(contact) + "\n";
  }
  return out;
}

}  // namespace bw
