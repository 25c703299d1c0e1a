#include "components/lab/bench/crowdnav_episode.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "components/lab/bench/crowd_generator.hpp"
#include "components/lab/bench/crowdnav_verdict.hpp"

namespace bw {
namespace {

constexpr double kDiscomfort = 0.2;  // [m]
constexpr int kAhead = 5;            // [steps] of the future that is intruded into
// Steps for which a motion must stay clear after a contact: more than a search's 5 s.
constexpr int kStepsAfter = 24;

// The verdict on a step, when it ends the drive.
std::optional<CrowdNavOutcome> verdict(double begin, double limit, double gap, double to_goal) {
  if (begin >= limit - 1.0) return CrowdNavOutcome::timeout;
  if (gap < 0.0) return CrowdNavOutcome::collision;
  if (to_goal < kCrowdNavRadius) return CrowdNavOutcome::reached;
  return std::nullopt;
}

double gap_now(const Vector2& robot, const std::vector<CrowdNavAgent>& people) {
  double gap = std::numeric_limits<double>::infinity();
  for (const CrowdNavAgent& person : people)
    gap = std::min(gap, (person.position - robot).norm() - kCrowdNavRadius - person.radius);
  return gap;
}

// As CrowdNav++ has it: everybody as wide as CrowdNav's people.
bool is_intruding(const Vector2& robot, double range, CrowdNavPeople people, const CrowdNavAgent* seen) {
  std::vector<bool> within;
  for (const CrowdNavAgent& person : people.agents())
    within.push_back((person.position - robot).norm() - kCrowdNavRadius - person.radius <= range);
  for (int k = 0; k < kAhead; ++k) {
    people.walk(people.decide(seen), kCrowdNavStep);
    for (std::size_t i = 0; i < within.size(); ++i)
      if (within[i] && (people.agents()[i].position - robot).norm() < 2.0 * kCrowdNavRadius) return true;
  }
  return false;
}

}  // namespace

CrowdNavEpisode run_crowdnav(const CrowdNavScene& scene, CrowdNavRobot& robot,
                             const CrowdNavConditions& conditions, const CrowdNavObserver& observer) {
  CrowdNavEpisode episode;
  episode.name = scene.name;
  CrowdNavPeople people(scene);
  std::optional<CrowdNavOutcome> outcome;
  CrowdNavWalks walks{people.agents()};
  for (int step = 0; !outcome; ++step) {
    const double begin = step * kCrowdNavStep;
    const CrowdNavAgent agent = robot.agent();
    const CrowdNavAgent* seen = conditions.visible ? &agent : nullptr;
    if (observer) observer({begin, robot.pose(), agent.velocity, people.agents()});
    const std::vector<Vector2> velocities = people.decide(seen);
    if (scene.rules.newcomers && is_intruding(agent.position, scene.rules.sensed_range, people, seen))
      ++episode.intrusions;
    double gap = robot.step(people.agents(), velocities);
    people.walk(velocities, kCrowdNavStep);
    if (conditions.sampled) gap = gap_now(robot.agent().position, people.agents());
    robot.see(people.agents());
    episode.time = begin + kCrowdNavStep;
    const std::vector<CrowdNavAgent> gone = people.renew(episode.time, {robot.agent().position, scene.goal});
    walks.push_back(people.agents());
    walks.back().insert(walks.back().end(), gone.begin(), gone.end());
    episode.min_gap = std::min(episode.min_gap, gap);
    episode.path += (robot.agent().position - agent.position).norm();
    ++episode.steps;
    outcome = verdict(begin, scene.rules.time_limit, gap, (robot.agent().position - scene.goal).norm());
    if (!outcome && gap < kDiscomfort) ++episode.discomfort_steps;
  }
  episode.outcome = *outcome;
  if (episode.outcome == CrowdNavOutcome::collision) {
    for (int step = 0; !conditions.visible && step < kStepsAfter; ++step) {
      people.walk(people.decide(nullptr), kCrowdNavStep);
      walks.push_back(people.agents());
    }
    episode.judged = judge_crowdnav(robot.motion(), walks, crowd_rules().limits);
  }
  if (episode.outcome == CrowdNavOutcome::timeout) episode.time = scene.rules.time_limit;
  episode.rms_jerk = robot.rms_jerk();
  episode.ms = robot.ms();
  return episode;
}

}  // namespace bw
