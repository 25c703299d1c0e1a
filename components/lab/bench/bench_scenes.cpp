#include "components/lab/bench/bench_scenes.hpp"

#include <cmath>
#include <cstdio>
#include <stdexcept>

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
      time{"time s", "mean (sigma)", {}}, quartiles{"time s", "quartiles", {}}, lost{"lost s", "mean", {}};
  for (const Row& row : rows) {
    const Durations t = durations_of(row.drives);
    rates.push_back(rates_of(row.planner, rated(row.drives)));
    success.cells.push_back(fmt::format("{:.3f}", rates.back().share(rates.back().successes)));
    sudden.cells.push_back(fmt::format("{}", only_sudden(row.drives)));
    time.cells.push_back(fmt::format("{:.2f} ({:.2f})", t.mean, t.sigma));
    quartiles.cells.push_back(
        fmt::format("{:.2f} / {:.2f} / {:.2f}", t.first_quartile, t.median, t.third_quartile));
    lost.cells.push_back(fmt::format("{:.2f}", t.mean - row.empty));
  }
  return drive_table(rates, {success, sudden, time, quartiles, lost});
}

class SceneBench {
 public:
  explicit SceneBench(const BenchScenesArguments& arguments) : arguments_(arguments) {
    if (arguments_.planners.empty()) throw std::runtime_error("a planner must be named");
    if (arguments_.adjust) arguments_.adjust(options_);
    for (const std::string& planner : arguments_.planners) make_planner(planner, options_);
  }

  int run(const std::vector<SceneSet>& sets, const DriveScene& empty) const {
    std::vector<Row> rows;
    for (const std::string& planner : arguments_.planners) {
      const BenchConditions conditions{BenchWeights::defaults, options_, empty.limits,
                                       Budget{}.max_iterations};
      const SceneDrive alone = drive(planner, empty, process_cpu_ms);
      rows.push_back({planner, alone.duration, {}});
      std::printf("%s; %s\nwithout anybody: %.2f s\n", planner.c_str(), in_a_line(conditions).c_str(),
                  alone.duration);
    }
    Json all = Json::array();
    for (const SceneSet& set : sets) {
      std::string failed;
      for (Row& row : rows) {
        row.drives = drives(row.planner, set.scenes);
        failed += failures(row.planner, rated(row.drives));
        all.push_back(json_of(set.name, row));
        write_json(arguments_.json, {{"prediction", to_text(arguments_.prediction)}, {"rows", all}});
      }
      std::printf("\n%s%s, prediction %s\n%s", failed.c_str(), set.name.c_str(),
                  to_text(arguments_.prediction), table_of(rows).c_str());
    }
    return 0;
  }

 private:
  SceneDrive drive(const std::string& planner, const DriveScene& scene, const CpuClock& clock) const {
    const std::unique_ptr<LocalPlanner> driver = make_planner(planner, options_);
    return drive_scene(scene, arguments_.prediction, *driver, clock);
  }

  std::vector<SceneDrive> drives(const std::string& planner, const std::vector<DriveScene>& scenes) const {
    const auto one = [&](std::size_t i, const CpuClock& clock) { return drive(planner, scenes[i], clock); };
    const auto tell = [](const SceneDrive& d) {
      std::fputs(in_a_line(d).c_str(), stdout);
      std::fflush(stdout);
    };
    return run_in_order(scenes.size(), arguments_.jobs, one, tell);
  }

  const BenchScenesArguments& arguments_;
  PlannerOptions options_;
};

}  // namespace

int bench_scenes(const std::vector<SceneSet>& sets, const DriveScene& empty,
                 const BenchScenesArguments& arguments) {
  return SceneBench(arguments).run(sets, empty);
}

}  // namespace bw
