#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "components/lab/bench/bench.hpp"
#include "components/lab/bench/bench_common.hpp"
#include "components/lab/bench/bench_conditions.hpp"
#include "components/lab/bench/crowd_generator.hpp"
#include "components/lab/bench/crowd_recording.hpp"
#include "components/lab/bench/crowd_report.hpp"
#include "components/lab/bench/crowd_samples.hpp"
#include "components/lab/bench/crowd_verdict.hpp"
#include "components/lab/bench/ordered_run.hpp"
#include "components/lab/bench/scene_writer.hpp"
#include "components/lab/failures/failure_album.hpp"
#include "runtime/atomic_file.hpp"

namespace bw {
namespace {

using Json = nlohmann::ordered_json;

/// Scenes of one kind.
struct Crowd {
  std::string name;  ///< empty: the only one
  std::optional<double> density;
  SceneFile file;
};

SceneFile scenes_of(const BenchCrowdArguments& arguments, std::optional<double> density) {
  if (arguments.scenes.empty() && arguments.generate <= 0)
    throw std::runtime_error("either a scene file or a number of scenes to generate must be given");
  SceneFile file = arguments.scenes.empty() ? crowd_rules() : read_scene_file(arguments.scenes);
  if (!file.closed_loop)
    throw std::runtime_error(arguments.scenes + ": control_period is missing: not a closed-loop file");
  if (density && arguments.generate <= 0) throw std::runtime_error("--density is of generated scenes");
  if (arguments.generate > 0) {
    file.scenes = density ? generate_dense_crowd(arguments.generate, arguments.first_seed, *density)
                          : generate_crowd(arguments.generate, arguments.first_seed);
  }
  file.scenes = select_scenes(file, arguments.scene);
  return file;
}

std::vector<Crowd> crowds_of(const BenchCrowdArguments& arguments) {
  std::vector<std::optional<double>> densities(arguments.densities.begin(), arguments.densities.end());
  if (densities.empty()) densities.emplace_back();
  std::vector<Crowd> crowds;
  for (const std::optional<double>& density : densities) {
    for (const WalkersManner walkers : arguments.walkers) {
      Crowd crowd{"", density, scenes_of(arguments, density)};
      crowd.file.closed_loop->walkers = walkers;
      if (density) crowd.name = fmt::format("{:g} per m^2, ", *density);
      crowd.name += fmt::format("walkers {}", text_of(walkers));
      crowds.push_back(std::move(crowd));
    }
  }
  if (crowds.empty()) throw std::runtime_error("a manner of walking must be named");
  return crowds;
}

PlannerOptions options_of(const BenchCrowdArguments& arguments, const SceneFile& file) {
  PlannerOptions options;
  if (arguments.weights == BenchWeights::file)
    options = options_for(file, arguments.weights, options, file.closed_loop->robot_radius);
  if (arguments.adjust) arguments.adjust(options);
  return options;
}

class CrowdBench {
 public:
  explicit CrowdBench(const BenchCrowdArguments& arguments)
      : arguments_(arguments),
        crowds_(crowds_of(arguments)),
        options_(options_of(arguments, crowds_.front().file)) {
    if (arguments_.planners.empty()) throw std::runtime_error("a planner must be named");
    // A wrong name is found before the first scene is driven.
    std::vector<ComparedRow> rows;
    for (const std::string& planner : arguments_.planners) {
      make_planner(planner, options_);
      rows.push_back({planner, {}});
    }
    row_against(rows, arguments_.against);
    if (!arguments_.write_scenes.empty())
      write_file_atomically(arguments_.write_scenes, to_yaml(crowds_.front().file));
    if (!arguments_.failures.empty()) album_.emplace(arguments_.failures, arguments_.write_page);
  }

  int run() {
    Json crowds = Json::array();
    for (const Crowd& crowd : crowds_) {
      Json result = run(crowd);
      if (crowds_.size() == 1) {
        write_json(arguments_.json, result["planners"].size() == 1 ? result["planners"][0] : result);
        break;
      }
      Json named = {{"crowd", crowd.name},
                    {"density", crowd.density ? Json(*crowd.density) : Json()},
                    {"walkers", text_of(crowd.file.closed_loop->walkers)}};
      named.update(result);
      crowds.push_back(std::move(named));
      write_json(arguments_.json, {{"crowds", crowds}});
    }
    if (crowds_.size() > 1) std::fputs(("\n" + tables_).c_str(), stdout);
    return 0;
  }

 private:
  Json run(const Crowd& crowd) {
    const SceneFile& file = crowd.file;
    const BenchConditions conditions{arguments_.weights, options_, file.limits, Budget{}.max_iterations};
    if (crowds_.size() > 1) std::printf("%s\n", crowd.name.c_str());
    std::vector<CrowdSummary> summaries;
    std::vector<ComparedRow> rows;
    std::string failed;
    Json results = Json::array();
    for (const std::string& planner : arguments_.planners) {
      std::printf("%s; %s\n", planner.c_str(), in_a_line(conditions).c_str());
      std::vector<std::vector<CrowdSample>> samples(file.scenes.size());
      const std::vector<CrowdEpisode> episodes = drive(planner, file, samples);
      summaries.push_back(summarize(planner, episodes));
      rows.push_back({planner, paired(episodes)});
      failed += failures(planner, rated(episodes));
      picture_failures(crowd, planner, episodes);
      results.push_back(to_json(summaries.back(), episodes));
      results.back()["conditions"] = to_json(conditions);
      results.back()["walkers"] = text_of(file.closed_loop->walkers);
      for (std::size_t i = 0; arguments_.with_samples && i < episodes.size(); ++i)
        results.back()["episodes"][i]["samples"] = to_json(samples[i]);
    }
    const ComparisonSummary comparison = summarize(rows, arguments_.against);
    const std::string tables = table(summaries) + in_words(comparison);
    std::fputs(("\n" + failed + tables).c_str(), stdout);
    tables_ += crowd.name + "\n" + tables + "\n";
    return {{"planners", std::move(results)}, {"comparison", to_json(comparison)}};
  }

  std::vector<CrowdEpisode> drive(const std::string& planner, const SceneFile& file,
                                  std::vector<std::vector<CrowdSample>>& samples) const {
    const auto one = [&](std::size_t i, const CpuClock& clock) {
      const std::unique_ptr<LocalPlanner> driver = make_planner(planner, options_);
      CrowdEpisode episode = drive_crowd_sampled(file.scenes[i], file, *driver, clock, samples[i]);
      if (!arguments_.with_samples) samples[i] = {};
      episode.judged = judge_crowd(file.scenes[i], file, episode);
      episode.walks = {};  // large, and no longer asked for
      return episode;
    };
    return run_in_order(file.scenes.size(), arguments_.jobs, one);
  }

  /// Drives that failed once more, the same ones, and looked at: few do, so that this costs less than to keep
  /// them all.
  void picture_failures(const Crowd& crowd, const std::string& planner,
                        const std::vector<CrowdEpisode>& episodes) {
    for (std::size_t i = 0; i < episodes.size() && album_ && !album_->is_full(); ++i) {
      const CrowdEpisode& episode = episodes[i];
      if (episode.success) continue;
      const std::unique_ptr<LocalPlanner> driver = make_planner(planner, options_);
      const RunRecording recording = record_crowd(crowd.file.scenes[i], crowd.file, *driver);
      const std::string_view walkers = text_of(crowd.file.closed_loop->walkers);
      album_->add({.title = fmt::format("{}, {}, walkers {}", planner, episode.name, walkers),
                   .outcome = outcome_in_words(episode),
                   .reached = episode.reached,
                   .contacts = episode.judged},
                  recording);
    }
  }

  const BenchCrowdArguments& arguments_;
  std::vector<Crowd> crowds_;
  PlannerOptions options_;
  std::optional<FailureAlbum> album_;
  std::string tables_;  ///< of all crowds
};

}  // namespace

int bench_crowd(const BenchCrowdArguments& arguments) { return CrowdBench(arguments).run(); }

}  // namespace bw
