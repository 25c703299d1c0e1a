#include <cstdio>
#include <memory>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "components/tools/bench/bench.hpp"
#include "components/tools/bench/bench_common.hpp"
#include "components/tools/bench/bench_conditions.hpp"
#include "components/tools/bench/crowd_generator.hpp"
#include "components/tools/bench/crowd_report.hpp"
#include "components/tools/bench/crowd_samples.hpp"
#include "components/tools/bench/crowd_verdict.hpp"
#include "components/tools/bench/ordered_run.hpp"
#include "components/tools/bench/scene_writer.hpp"
#include "runtime/atomic_file.hpp"

namespace bw {
namespace {

SceneFile scenes_of(const BenchCrowdArguments& arguments) {
  if (arguments.scenes.empty() && arguments.generate <= 0)
    throw std::runtime_error("either a scene file or a number of scenes to generate must be given");
  SceneFile file = arguments.scenes.empty() ? crowd_rules() : read_scene_file(arguments.scenes);
  if (!file.closed_loop)
    throw std::runtime_error(arguments.scenes + ": control_period is missing: not a closed-loop file");
  if (arguments.generate > 0) file.scenes = generate_crowd(arguments.generate, arguments.first_seed);
  file.scenes = select_scenes(file, arguments.scene);
  return file;
}

LocalPlannerOptions options_of(const BenchCrowdArguments& arguments, const SceneFile& file) {
  LocalPlannerOptions options;
  if (arguments.weights == BenchWeights::file)
    options = options_for(file, arguments.weights, options, file.closed_loop->robot_radius);
  if (arguments.adjust) arguments.adjust(options);
  return options;
}

}  // namespace

int bench_crowd(const BenchCrowdArguments& arguments) {
  const SceneFile file = scenes_of(arguments);
  const LocalPlannerOptions options = options_of(arguments, file);
  if (arguments.planners.empty()) throw std::runtime_error("a planner must be named");
  // A wrong name is found before the first scene is driven.
  for (const std::string& planner : arguments.planners) make_planner(planner, options);
  if (!arguments.write_scenes.empty()) write_file_atomically(arguments.write_scenes, to_yaml(file));

  const BenchConditions conditions{arguments.weights, options, file.limits, Budget{}.max_iterations};
  std::vector<CrowdSummary> summaries;
  std::string failed;
  nlohmann::ordered_json results = nlohmann::ordered_json::array();
  for (const std::string& planner : arguments.planners) {
    std::printf("%s; %s\n", planner.c_str(), in_a_line(conditions).c_str());
    std::vector<std::vector<CrowdSample>> samples(file.scenes.size());
    const auto drive = [&](std::size_t i, const CpuClock& clock) {
      const std::unique_ptr<LocalPlanner> driver = make_planner(planner, options);
      CrowdEpisode episode = drive_crowd_sampled(file.scenes[i], file, *driver, clock, samples[i]);
      episode.judged = judge_crowd(file.scenes[i], file, episode);
      return episode;
    };
    const auto tell = [](const CrowdEpisode& episode) {
      std::fputs(in_a_line(episode).c_str(), stdout);
      std::fflush(stdout);
    };
    const std::vector<CrowdEpisode> episodes = run_in_order(file.scenes.size(), arguments.jobs, drive, tell);
    summaries.push_back(summarize(planner, episodes));
    failed += failures(planner, episodes);
    results.push_back(to_json(summaries.back(), episodes));
    results.back()["conditions"] = to_json(conditions);
    for (std::size_t i = 0; arguments.with_samples && i < episodes.size(); ++i)
      results.back()["episodes"][i]["samples"] = to_json(samples[i]);
  }
  std::fputs(("\n" + failed + table(summaries)).c_str(), stdout);
  if (results.size() == 1) {
    write_json(arguments.json, results.front());
  } else {
    write_json(arguments.json, {{"planners", std::move(results)}});
  }
  return 0;
}

}  // namespace bw
