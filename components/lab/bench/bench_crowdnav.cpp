#include "components/lab/bench/bench_crowdnav.hpp"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "components/lab/bench/bench_conditions.hpp"
#include "components/lab/bench/crowd_generator.hpp"
#include "components/lab/bench/ordered_run.hpp"

namespace bw {
namespace {

using Json = nlohmann::ordered_json;

class CrowdNavBench {
 public:
  explicit CrowdNavBench(const BenchCrowdNavArguments& arguments) : arguments_(arguments) {
    if (arguments_.first_case < 0 || arguments_.first_case >= kCrowdNavCases)
      throw std::runtime_error(fmt::format("the cases are 0 to {}", kCrowdNavCases - 1));
    if (arguments_.planners.empty()) throw std::runtime_error("a planner must be named");
    cases_ = std::clamp(arguments_.cases, 1, kCrowdNavCases - arguments_.first_case);
    const bool is_crowd = crowdnav_scene(arguments_.crossing, 0).rules.newcomers;
    if (!is_crowd && std::ranges::find(arguments_.planners, kPublishedOrca) != arguments_.planners.end())
      throw std::runtime_error(fmt::format("{} is of the crowds", kPublishedOrca));
    if (arguments_.adjust) arguments_.adjust(options_);
    // A wrong name is found before the first case is driven.
    for (const std::string& planner : arguments_.planners)
      if (!is_holonomic(planner)) make_planner(planner, options_);
  }

  int run() {
    std::vector<CrowdNavSummary> summaries;
    std::string failed;
    Json rows = Json::array();
    for (const std::string& planner : arguments_.planners) {
      std::printf("%s; %s\n", planner.c_str(), conditions_of(planner).c_str());
      std::vector<Json> samples(static_cast<std::size_t>(cases_), Json::array());
      const auto drive = [&](std::size_t i, const CpuClock& clock) {
        return drive_case(planner, static_cast<int>(i), clock, samples[i]);
      };
      const std::vector<CrowdNavEpisode> episodes =
          run_in_order(static_cast<std::size_t>(cases_), arguments_.jobs, drive);
      summaries.push_back(summarize(planner, episodes));
      if (!is_holonomic(planner)) failed += failures(planner, rated(episodes));
      rows.push_back(to_json(summaries.back(), episodes));
      if (!is_holonomic(planner)) rows.back()["conditions"] = to_json(bench_conditions());
      for (std::size_t i = 0; arguments_.with_samples && i < samples.size(); ++i)
        rows.back()["episodes"][i]["samples"] = std::move(samples[i]);
    }
    const char* scene = to_text(arguments_.crossing);
    const CrowdNavConditions& conditions = arguments_.conditions;
    std::printf("\n%s%s, robot %s, contacts %s, cases %d to %d\n%s", failed.c_str(), scene,
                conditions.visible ? "visible" : "invisible",
                conditions.sampled ? "at the ends of steps" : "at any time", arguments_.first_case,
                arguments_.first_case + cases_ - 1, table(summaries).c_str());
    write_json(arguments_.json, {{"scene", scene},
                                 {"visible", conditions.visible},
                                 {"sampled", conditions.sampled},
                                 {"planners", std::move(rows)}});
    return 0;
  }

 private:
  CrowdNavEpisode drive_case(const std::string& name, int index, const CpuClock& clock, Json& samples) const {
    const CrowdNavScene scene = crowdnav_scene(arguments_.crossing, arguments_.first_case + index);
    CrowdNavObserver observer;
    if (arguments_.with_samples)
      observer = [&samples](const CrowdNavSample& sample) { samples.push_back(to_json(sample)); };
    std::unique_ptr<LocalPlanner> planner;
    std::unique_ptr<CrowdNavRobot> robot;
    if (name == kHolonomicOrca) {
      robot = holonomic_orca_robot(scene, arguments_.safety_space.value_or(scene.rules.people_margin), clock);
    } else if (name == kPublishedOrca) {
      robot = published_orca_robot(scene, clock);
    } else if (name == kHolonomicSocialForce) {
      robot = holonomic_robot(scene, crowdnav_social_force, clock);
    } else {
      planner = make_planner(name, options_);
      robot = planner_robot(scene, *planner, clock);
    }
    return run_crowdnav(scene, *robot, arguments_.conditions, observer);
  }

  static bool is_holonomic(const std::string& planner) {
    return planner == kHolonomicOrca || planner == kPublishedOrca || planner == kHolonomicSocialForce;
  }

  BenchConditions bench_conditions() const {
    return {BenchWeights::defaults, options_, crowd_rules().limits, Budget{}.max_iterations};
  }

  std::string conditions_of(const std::string& planner) const {
    if (!is_holonomic(planner)) return in_a_line(bench_conditions());
    return fmt::format("any velocity up to 1 m/s every {:g} s", kCrowdNavStep);
  }

  const BenchCrowdNavArguments& arguments_;
  PlannerOptions options_;
  int cases_ = 0;
};

}  // namespace

int bench_crowdnav(const BenchCrowdNavArguments& arguments) { return CrowdNavBench(arguments).run(); }

}  // namespace bw
