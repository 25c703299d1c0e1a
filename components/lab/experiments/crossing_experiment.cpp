#include "components/lab/experiments/crossing_experiment.hpp"

#include <algorithm>
#include <memory>

#include "components/lab/bench/bench_common.hpp"
#include "components/local_planner/planner_registry.hpp"
#include "runtime/parameters/overrides.hpp"
#include "runtime/parameters/parameters.hpp"

namespace bw {
namespace {

PlannerOptions options_of(const CrossingEntry& entry) {
  ConfigNode root;
  for (const std::string& text : entry.set) apply_override(root, parse_override(text));
  return read_parameters<PlannerOptions>(root, "");
}

}  // namespace

CrossingResult run_crossing(const CrossingEntry& entry, const CrossingGeometry& geometry, int runs) {
  const SceneFile rules = crossing_rules();
  const PlannerOptions options = options_of(entry);
  CrossingResult result{entry, {}};
  for (int i = 1; i <= runs; ++i) {
    CrossingRun run;
    run.seed = static_cast<std::uint64_t>(i);
    const Scene scene = crossing_scene(geometry, run.seed);
    run.path.push_back({0.0, scene.start.position()});
    const std::unique_ptr<LocalPlanner> planner = make_planner(entry.planner, options);
    run.episode = drive_crowd(scene, rules, *planner, process_cpu_ms,
                              [&run](double time, const Pose2& pose, const Twist2&) {
                                run.path.push_back({time, pose.position()});
                              });
    run.passing_a = passing(run.path, walk_of(scene.obstacles[0]));
    run.passing_b = passing(run.path, walk_of(scene.obstacles[1]));
    result.runs.push_back(std::move(run));
  }
  return result;
}

std::vector<CrossingSnapshot> crossing_snapshots(const CrossingEntry& entry, const CrossingGeometry& geometry,
                                                 std::uint64_t seed, const std::vector<double>& times) {
  const Scene scene = crossing_scene(geometry, seed);
  const std::unique_ptr<LocalPlanner> planner = make_planner(entry.planner, options_of(entry));
  std::vector<CrossingSnapshot> snapshots;
  std::vector<Vector2> path{scene.start.position()};
  drive_crowd(
      scene, crossing_rules(), *planner, process_cpu_ms,
      [&path](double, const Pose2& pose, const Twist2&) { path.push_back(pose.position()); },
      [&](double time, const PlanningProblem& problem, const PlanningResult& result) {
        if (snapshots.size() == times.size() || time + 1e-9 < times[snapshots.size()]) return;
        snapshots.push_back({time, problem.pose, problem.movers, path, result});
      });
  return snapshots;
}

CrossingSummary summarize(const CrossingResult& result) {
  CrossingSummary s;
  s.runs = static_cast<int>(result.runs.size());
  if (s.runs == 0) return s;
  for (const CrossingRun& run : result.runs) {
    const CrowdEpisode& e = run.episode;
    s.successes += e.success ? 1 : 0;
    s.contacts += e.collision ? 1 : 0;
    s.share_behind_a += run.passing_a == Passing::behind ? 1.0 : 0.0;
    s.share_behind_b += run.passing_b == Passing::behind ? 1.0 : 0.0;
    s.mean_max_collision_index += e.max_collision_index;
    s.max_collision_index = std::max(s.max_collision_index, e.max_collision_index);
    s.mean_time += e.time;
    s.mean_min_clearance += e.min_clearance;
  }
  for (double* figure : {&s.share_behind_a, &s.share_behind_b, &s.mean_max_collision_index, &s.mean_time,
                         &s.mean_min_clearance})
    *figure /= s.runs;
  return s;
}

}  // namespace bw
