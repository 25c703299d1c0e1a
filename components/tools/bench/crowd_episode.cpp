#include "components/tools/bench/crowd_episode.hpp"

#include <algorithm>
#include <cmath>

#include "components/tools/bench/crowd_walk.hpp"
#include "components/tools/bench/unicycle.hpp"

namespace bw {
namespace {

constexpr int kStepsPerPeriod = 5;
constexpr double kCollisionIndexSigma = 0.6;  // [m] book 7.7

PlanningProblem problem_at(const Scene& scene, const SceneFile& file, double time, const Pose2& pose,
                           const Twist2& twist) {
  const ClosedLoop& rule = *file.closed_loop;
  PlanningProblem problem;
  problem.now = Time::seconds(1.0 + time);
  problem.pose = pose;
  problem.twist = twist;
  problem.plan = {scene.start, scene.goal};
  problem.footprint.radius = rule.robot_radius;
  problem.limits = file.limits;
  problem.control_period = rule.control_period;
  std::uint32_t id = 0;
  for (const SceneObstacle& o : scene.obstacles) {
    ++id;
    if (!o.moves()) {
      problem.obstacles.discs.push_back({o.position, o.radius});
      continue;
    }
    Mover mover;
    mover.id = id;
    mover.position = position_at(o, rule.box, time);
    mover.velocity = velocity_at(o, rule.box, time);
    mover.radius = o.radius;
    problem.movers.push_back(mover);
  }
  return problem;
}

TruthSample truth_at(const Scene& scene, const SceneBox& box, double time, const Pose2& pose,
                     const Twist2& twist) {
  TruthSample sample;
  sample.time = Time::seconds(time);
  sample.X_MB = pose;
  sample.twist = twist;
  std::uint32_t id = 0;
  for (const SceneObstacle& o : scene.obstacles)
    sample.people.push_back({++id, position_at(o, box, time), velocity_at(o, box, time), o.radius});
  return sample;
}

void judge(const Scene& scene, const ClosedLoop& rule, double time, const Pose2& pose, const Twist2& twist,
           CrowdEpisode& episode) {
  double clearance = std::numeric_limits<double>::infinity();
  for (const SceneObstacle& o : scene.obstacles) {
    const double centre = (position_at(o, rule.box, time) - pose.position()).norm();
    clearance = std::min(clearance, centre - o.radius);
    if (!o.moves()) continue;
    const double index = std::exp(-centre * centre / (2.0 * kCollisionIndexSigma * kCollisionIndexSigma));
    episode.max_collision_index = std::max(episode.max_collision_index, index);
  }
  episode.min_clearance = std::min(episode.min_clearance, clearance);
  if (clearance >= rule.robot_radius) return;
  episode.collision = true;
  if (std::abs(twist.v) > kStandingSpeed) episode.collision_at_speed = true;
}

}  // namespace

CrowdEpisode drive_crowd(const Scene& scene, const SceneFile& file, LocalPlanner& planner,
                         const CpuClock& clock, const StepObserver& observer,
                         const PlanObserver& plan_observer) {
  const ClosedLoop& rule = *file.closed_loop;
  const double period = rule.control_period;
  CrowdEpisode episode;
  episode.name = scene.name;
  Pose2 pose = scene.start;
  Twist2 twist;
  std::vector<double> accelerations;
  ContactDiary diary;
  const Footprint footprint{rule.robot_radius, {}};
  const int cycles = static_cast<int>(std::lround(rule.timeout / period));
  for (int cycle = 0; cycle < cycles; ++cycle) {
    const double begin = cycle * period;
    const PlanningProblem problem = problem_at(scene, file, begin, pose, twist);
    const double before = clock();
    const PlanningResult result = planner.plan(problem);
    episode.ms.push_back(clock() - before);
    if (result.status != PlanningStatus::ok) ++episode.not_ok;
    if (plan_observer) plan_observer(begin, problem, result);

    episode.states.push_back({begin, pose, twist});
    const Twist2 last = twist;
    twist = applied_twist(result.command, last, file.limits, period);
    accelerations.push_back((twist.v - last.v) / period);
    const double h = period / kStepsPerPeriod;
    for (int step = 1; step <= kStepsPerPeriod; ++step) {
      pose = unicycle_step(pose, twist, h);
      judge(scene, rule, begin + step * h, pose, twist, episode);
      diary.add(begin + step * h, truth_at(scene, rule.box, begin + step * h, pose, twist), footprint);
      if (observer) observer(begin + step * h, pose, twist);
    }
    episode.time = begin + period;
    if ((pose.position() - scene.goal.position()).norm() <= rule.goal_tolerance) {
      episode.reached = true;
      episode.success = !episode.collision;
      break;
    }
  }
  episode.rms_jerk = rms_jerk(accelerations, period);
  episode.contacts = diary.contacts();
  return episode;
}

}  // namespace bw
