#include "components/lab/bench/bench_scenes.hpp"

#include <cmath>
#include <cstdio>
#include <map>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "components/lab/bench/bench_common.hpp"
#include "components/lab/bench/bench_conditions.hpp"
#include "components/lab/bench/ordered_run.hpp"
#include "runtime/base/quantile.hpp"

namespace bw {
namespace {

using Json = nlohmann::ordered_json;

/// Of drives that passed, with contacts or without, as the published ones.
struct Durations {
  double mean = 0.0, sigma = 0.0;
  double first_quartile = 0.0, median = 0.0, third_quartile = 0.0;
};

Durations durations_of(const std::vector<SceneDrive>& drives) {
  std::vector<double> times;
  for (const SceneDrive& d : drives)
    if (d.passed) times.push_back(d.duration);
  Durations t;
  if (times.empty()) return t;
  t.mean = mean(times);
  double squares = 0.0;
  for (const double time : times) squares += (time - t.mean) * (time - t.mean);
  t.sigma = std::sqrt(squares / static_cast<double>(times.size()));
  t.first_quartile = quantile(times, 0.25);
  t.median = quantile(times, 0.5);
  t.third_quartile = quantile(times, 0.75);
  return t;
}

struct Row {
  std::string planner;
  double empty = 0.0;  ///< [s] that it takes where nobody is
  std::vector<SceneDrive> drives;
};

Json json_of(const std::string& set, const Row& row) {
  const Durations t = durations_of(row.drives);
  Json summary = to_json(rates_of(row.planner, rated(row.drives)));
  summary.update(Json{{"empty_s", row.empty},
                      {"duration_s",
                       {{"mean", t.mean},
                        {"sigma", t.sigma},
                        {"quartiles", {t.first_quartile, t.median, t.third_quartile}}}}});
  return {{"set", set},
          {"planner", row.planner},
          {"drives", to_json(row.drives)},
          {"summary", std::move(summary)}};
}

// Contacts with who came to be less than a second before are told beside the others.
int only_sudden(const std::vector<SceneDrive>& drives) {
  int count = 0;
  for (const SceneDrive& d : drives)
    if (d.passed && d.contacts > 0 && d.contacts == d.sudden_contacts) ++count;
  return count;
}

std::string table_of(const std::vector<Row>& rows) {
  std::vector<DriveRates> rates;
  OwnColumn success{"success", "share", {}}, sudden{"sudden", "only these", {}},
      time{"time s", "mean (sigma)", {}}, quartiles{"time s", "quartiles", {}}, alone{"time s", "alone", {}},
      lost{"lost s", "mean", {}};
  for (const Row& row : rows) {
    const Durations t = durations_of(row.drives);
    rates.push_back(rates_of(row.planner, rated(row.drives)));
    success.cells.push_back(fmt::format("{:.3f}", rates.back().share(rates.back().successes)));
    sudden.cells.push_back(fmt::format("{}", only_sudden(row.drives)));
    time.cells.push_back(fmt::format("{:.2f} ({:.2f})", t.mean, t.sigma));
    quartiles.cells.push_back(
        fmt::format("{:.2f} / {:.2f} / {:.2f}", t.first_quartile, t.median, t.third_quartile));
    alone.cells.push_back(fmt::format("{:.2f}", row.empty));
    lost.cells.push_back(fmt::format("{:.2f}", t.mean - row.empty));
  }
  return drive_table(rates, {success, sudden, time, quartiles, alone, lost});
}

class SceneBench {
 public:
  explicit SceneBench(const BenchScenesArguments& arguments) : arguments_(arguments) {
    if (arguments_.planners.empty()) throw std::runtime_error("a planner must be named");
    if (arguments_.adjust) arguments_.adjust(options_);
    for (const std::string& planner : arguments_.planners) make_planner(planner, options_);
  }

  int run(const std::vector<SceneSet>& sets) const {
    Json all = Json::array();
    std::map<std::pair<std::string, std::string>, double> empty_s;  // by planner and scene, which sets share
    bool missed_any = false;
    for (const SceneSet& set : sets) {
      std::vector<Row> rows;
      std::string failed, gates;
      for (const std::string& planner : arguments_.planners) {
        const BenchConditions conditions{BenchWeights::defaults, options_, set.empty.limits,
                                         Budget{}.max_iterations};
        std::printf("%s; %s\n", planner.c_str(), in_a_line(conditions).c_str());
        const auto [alone, is_new] = empty_s.try_emplace({planner, set.empty.name});
        if (is_new) alone->second = drive(planner, set.empty, process_cpu_ms).duration;
        rows.push_back({planner, alone->second, {}});
        Row& row = rows.back();
        row.drives = drives(planner, set.scenes);
        failed += failures(planner, rated(row.drives));
        all.push_back(json_of(set.name, row));
        if (set.gate) {
          const std::string what = missed(*set.gate, row.drives);
          gates += fmt::format("gate of {}: {}\n", planner, what.empty() ? "met" : "MISSED, " + what);
          all.back()["gate_missed"] = what;
          missed_any |= !what.empty();
        }
        write_json(arguments_.json, {{"prediction", to_text(arguments_.prediction)}, {"rows", all}});
      }
      std::printf("\n%s%s, prediction %s\n%s%s", failed.c_str(), set.name.c_str(),
                  to_text(arguments_.prediction), table_of(rows).c_str(), gates.c_str());
    }
    return arguments_.check && missed_any ? 1 : 0;
  }

 private:
  SceneDrive drive(const std::string& planner, const DriveScene& scene, const CpuClock& clock) const {
    const std::unique_ptr<LocalPlanner> driver = make_planner(planner, options_);
    return drive_scene(scene, arguments_.prediction, *driver, clock);
  }

  std::vector<SceneDrive> drives(const std::string& planner, const std::vector<DriveScene>& scenes) const {
    const auto one = [&](std::size_t i, const CpuClock& clock) { return drive(planner, scenes[i], clock); };
    return run_in_order(scenes.size(), arguments_.jobs, one);
  }

  const BenchScenesArguments& arguments_;
  PlannerOptions options_;
};

}  // namespace

std::string missed(const SceneGate& gate, const std::vector<SceneDrive>& drives) {
  const double count = static_cast<double>(drives.size());
  double successes = 0.0, stuck = 0.0;
  int closing = 0, at_speed = 0;
  for (const SceneDrive& drive : drives) {
    successes += drive.success() ? 1.0 : 0.0;
    stuck += drive.passed ? 0.0 : 1.0;
    closing += drive.wall ? 1 : 0;
    at_speed += drive.wall ? 1 : 0;
    for (const JudgedContact& contact : drive.judged) {
      closing += contact.record.closing.who == WhoHit::robot_closing ? 1 : 0;
      at_speed += contact.record.at_speed ? 1 : 0;
    }
  }
  std::vector<std::string> all;
  constexpr double kRounding = 1e-9;
  if (successes < gate.least_success * count - kRounding)
    all.push_back(fmt::format("success {:.3f} of {:.3f}", successes / count, gate.least_success));
  if (stuck > gate.most_stuck * count + kRounding)
    all.push_back(fmt::format("{:.3f} do not pass of {:.3f}", stuck / count, gate.most_stuck));
  if (gate.no_robot_closing && closing > 0)
    all.push_back(fmt::format("{} contacts that the robot drove into", closing));
  if (gate.no_contact_at_speed && at_speed > 0) all.push_back(fmt::format("{} contacts at speed", at_speed));
  return fmt::format("{}", fmt::join(all, ", "));
}

int bench_scenes(const std::vector<SceneSet>& sets, const BenchScenesArguments& arguments) {
  return SceneBench(arguments).run(sets);
}

}  // namespace bw
