#include "components/lab/tune/tune_suite.hpp"

#include "components/lab/bench/corridor/corridor_scene.hpp"
#include "components/lab/bench/crowd_episode.hpp"
#include "components/lab/bench/crowd_generator.hpp"
#include "components/lab/bench/crowdnav_episode.hpp"

namespace bw::tune {
namespace {

constexpr int kCorridorPeople = 12;

double no_clock() { return 0.0; }

}  // namespace

TuneDrive drive_episode(TuneSuite suite, std::uint64_t episode, const std::string& name,
                        const PlannerOptions& options) {
  const std::unique_ptr<LocalPlanner> planner = make_planner(name, options);
  switch (suite) {
    case TuneSuite::crowd: {
      const SceneFile rules = crowd_rules();
      const CrowdEpisode drive = drive_crowd(generate_crowd_scene(episode), rules, *planner, no_clock);
      return {drive.success, drive.time, rules.closed_loop->timeout};
    }
    case TuneSuite::crowdnav: {
      const CrowdNavScene scene = crowdnav_scene(CrowdNavCrossing::crowd, static_cast<int>(episode));
      const auto robot = planner_robot(scene, *planner, no_clock);
      const CrowdNavEpisode drive = run_crowdnav(scene, *robot, {});
      return {drive.outcome == CrowdNavOutcome::reached, drive.time, scene.rules.time_limit};
    }
    case TuneSuite::corridor: {
      const DriveScene scene = corridor_scene(kCorridorPeople, episode);
      const SceneDrive drive = drive_scene(scene, ScenePrediction::constant_velocity, *planner, no_clock);
      return {drive.success(), drive.duration, scene.timeout};
    }
  }
  return {};
}

}  // namespace bw::tune
