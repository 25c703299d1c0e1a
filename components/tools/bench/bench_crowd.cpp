#include <cstdio>
#include <future>
#include <mutex>
#include <optional>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "components/tools/bench/bench.hpp"
#include "components/tools/bench/bench_common.hpp"
#include "components/tools/bench/bench_conditions.hpp"
#include "components/tools/bench/crowd_generator.hpp"
#include "components/tools/bench/crowd_report.hpp"
#include "components/tools/bench/crowd_samples.hpp"
#include "components/tools/bench/crowd_verdict.hpp"
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

// Episodes handed to threads one by one, printed in the order of the file.
class CrowdRun {
 public:
  using PlannerMaker = std::function<std::unique_ptr<LocalPlanner>()>;

  CrowdRun(const SceneFile& file, PlannerMaker make)
      : file_(file), make_(std::move(make)), episodes_(file.scenes.size()), samples_(file.scenes.size()) {}

  std::vector<CrowdEpisode> run(int jobs) {
    if (jobs <= 1) {
      work(process_cpu_ms);
    } else {
      std::vector<std::future<void>> workers;
      workers.reserve(static_cast<std::size_t>(jobs));
      for (int job = 0; job < jobs; ++job)
        workers.push_back(std::async(std::launch::async, [this] { work(thread_cpu_ms); }));
      for (std::future<void>& worker : workers) worker.get();
    }
    std::vector<CrowdEpisode> episodes;
    for (std::optional<CrowdEpisode>& episode : episodes_) episodes.push_back(std::move(*episode));
    return episodes;
  }

  /// Of each episode, after run().
  const std::vector<std::vector<CrowdSample>>& samples() const { return samples_; }

 private:
  void work(const CpuClock& clock) {
    while (const std::optional<std::size_t> index = next()) {
      const std::unique_ptr<LocalPlanner> planner = make_();
      const Scene& scene = file_.scenes[*index];
      CrowdEpisode episode = drive_crowd_sampled(scene, file_, *planner, clock, samples_[*index]);
      episode.judged = judge_crowd(scene, file_, episode);
      finish(*index, std::move(episode));
    }
  }

  std::optional<std::size_t> next() {
    const std::lock_guard lock(mutex_);
    if (next_ == episodes_.size()) return std::nullopt;
    return next_++;
  }

  void finish(std::size_t index, CrowdEpisode episode) {
    const std::lock_guard lock(mutex_);
    episodes_[index] = std::move(episode);
    for (; printed_ < episodes_.size() && episodes_[printed_]; ++printed_)
      std::fputs(in_a_line(*episodes_[printed_]).c_str(), stdout);
    std::fflush(stdout);
  }

  const SceneFile& file_;
  PlannerMaker make_;
  std::mutex mutex_;
  std::size_t next_ = 0;
  std::size_t printed_ = 0;
  std::vector<std::optional<CrowdEpisode>> episodes_;
  std::vector<std::vector<CrowdSample>> samples_;
};

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
    CrowdRun run(file, [&] { return make_planner(planner, options); });
    const std::vector<CrowdEpisode> episodes = run.run(arguments.jobs);
    summaries.push_back(summarize(planner, episodes));
    failed += failures(planner, episodes);
    results.push_back(to_json(summaries.back(), episodes));
    results.back()["conditions"] = to_json(conditions);
    for (std::size_t i = 0; arguments.with_samples && i < episodes.size(); ++i)
      results.back()["episodes"][i]["samples"] = to_json(run.samples()[i]);
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
