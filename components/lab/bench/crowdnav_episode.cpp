#include "components/lab/bench/crowdnav_episode.hpp"

#include <algorithm>
#include <optional>

#include "components/lab/bench/crowd_generator.hpp"
#include "components/lab/bench/crowdnav_verdict.hpp"

namespace bw {
namespace {

constexpr double kTimeLimit = 25.0;  // [s]; a step that begins a second before is the last one
constexpr double kDiscomfort = 0.2;  // [m]
constexpr int kStepsAfter =
    24;  // for which a motion must stay clear after a contact: more than a search's 5 s

// The verdict on a step, when it ends the drive.
std::optional<CrowdNavOutcome> verdict(double begin, double gap, double to_goal) {
  if (begin >= kTimeLimit - 1.0) return CrowdNavOutcome::timeout;
  if (gap < 0.0) return CrowdNavOutcome::collision;
  if (to_goal < kCrowdNavRadius) return CrowdNavOutcome::reached;
  return std::nullopt;
}

}  // namespace

CrowdNavEpisode run_crowdnav(const CrowdNavScene& scene, CrowdNavRobot& robot, bool visible,
                             const CrowdNavObserver& observer) {
  CrowdNavEpisode episode;
  episode.name = scene.name;
  CrowdNavPeople people(scene);
  std::optional<CrowdNavOutcome> outcome;
  CrowdNavWalks walks{people.agents()};
  for (int step = 0; !outcome; ++step) {
    const double begin = step * kCrowdNavStep;
    const CrowdNavAgent agent = robot.agent();
    if (observer) observer({begin, robot.pose(), agent.velocity, people.agents()});
    const std::vector<Vector2> velocities = people.decide(visible ? &agent : nullptr);
    const double gap = robot.step(people.agents(), velocities);
    people.walk(velocities, kCrowdNavStep);
    walks.push_back(people.agents());
    episode.time = begin + kCrowdNavStep;
    episode.min_gap = std::min(episode.min_gap, gap);
    outcome = verdict(begin, gap, (robot.agent().position - scene.goal).norm());
    if (!outcome && gap < kDiscomfort) ++episode.discomfort_steps;
  }
  episode.outcome = *outcome;
  if (episode.outcome == CrowdNavOutcome::collision) {
    for (int step = 0; !visible && step < kStepsAfter; ++step) {
      people.walk(people.decide(nullptr), kCrowdNavStep);
      walks.push_back(people.agents());
    }
    episode.judged = judge_crowdnav(robot.motion(), walks, crowd_rules().limits);
  }
  if (episode.outcome == CrowdNavOutcome::timeout) episode.time = kTimeLimit;
  episode.rms_jerk = robot.rms_jerk();
  episode.ms = robot.ms();
  return episode;
}

}  // namespace bw
