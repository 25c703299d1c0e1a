#include "components/lab/bench/crowd_episode.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "components/evaluation/success.hpp"
#include "components/lab/bench/crowd_people.hpp"
#include "components/lab/bench/planner_alone.hpp"

namespace bw {
namespace {

constexpr int kStepsPerPeriod = 5;
constexpr double kCollisionIndexSigma = 0.6;  // [m] evaluation/theory.md 7.7

PlanningProblem problem_at(const Scene& scene, const CrowdPeople& people, double time,
                           const PlannedBase& base) {
  PlanningProblem problem = base.problem(time, {scene.start, scene.goal});
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
    const SceneObstacle& o = scene.obstacles[i];
    if (!people.walks(i)) {
      problem.obstacles.discs.push_back({o.position, o.radius});
      continue;
    }
    add_mover(problem, static_cast<std::uint32_t>(i) + 1, people.position(i), people.velocity(i), o.radius);
  }
  return problem;
}

TruthSample truth_at(const Scene& scene, const CrowdPeople& people, double time, const Pose2& pose,
                     const Twist2& twist) {
  TruthSample sample;
  sample.time = Time::seconds(time);
  sample.X_MB = pose;
  sample.twist = twist;
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i)
    sample.people.push_back({static_cast<std::uint32_t>(i) + 1, people.position(i), people.velocity(i),
                             scene.obstacles[i].radius});
  return sample;
}

void judge(const Scene& scene, const ClosedLoop& rule, const CrowdPeople& people, const Pose2& pose,
           const Twist2& twist, CrowdEpisode& episode) {
  double clearance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
    const double centre = (people.position(i) - pose.position()).norm();
    clearance = std::min(clearance, centre - scene.obstacles[i].radius);
    if (!people.walks(i)) continue;
    const double index = std::exp(-centre * centre / (2.0 * kCollisionIndexSigma * kCollisionIndexSigma));
    episode.max_collision_index = std::max(episode.max_collision_index, index);
  }
  episode.min_clearance = std::min(episode.min_clearance, clearance);
  if (clearance >= rule.robot_radius) return;
  episode.collision = true;
  if (std::abs(twist.v) > kStandingSpeed) episode.collision_at_speed = true;
}

/// How those walked who do not go straight on: of them nobody can tell but who was there.
class WalkKeeper {
 public:
  WalkKeeper(const Scene& scene, const ClosedLoop& rule) {
    if (rule.walkers == WalkersManner::straight) return;
    for (std::size_t i = 0; i < scene.obstacles.size(); ++i)
      if (scene.obstacles[i].moves()) obstacles_.push_back(i);
    for (const std::size_t i : obstacles_) walks_.push_back({scene.obstacles[i].radius, {}});
  }
  void keep(double time, const CrowdPeople& people) {
    for (std::size_t k = 0; k < obstacles_.size(); ++k)
      walks_[k].positions.push_back({time, people.position(obstacles_[k])});
  }
  std::vector<possible::Walk> take() && { return std::move(walks_); }

 private:
  std::vector<std::size_t> obstacles_;
  std::vector<possible::Walk> walks_;
};

}  // namespace

CrowdEpisode drive_crowd(const Scene& scene, const SceneFile& file, LocalPlanner& planner,
                         const CpuClock& clock, const StepObserver& observer,
                         const PlanObserver& plan_observer) {
  const ClosedLoop& rule = *file.closed_loop;
  const double period = rule.control_period;
  CrowdEpisode episode;
  episode.name = scene.name;
  PlannedBase base(scene.start, rule.robot_radius, file.limits, period, twice_the_limits(file.limits, period),
                   planner, clock);
  ContactDiary diary;
  const Footprint footprint{rule.robot_radius, {}};
  CrowdPeople people(scene, rule);
  WalkKeeper walks(scene, rule);
  const int cycles = static_cast<int>(std::lround(rule.timeout / period));
  for (int cycle = 0; cycle < cycles; ++cycle) {
    const double begin = cycle * period;
    people.move_to(begin, base.pose(), base.twist());
    if (cycle == 0) walks.keep(begin, people);
    const PlanningProblem problem = problem_at(scene, people, begin, base);
    episode.states.push_back({begin, base.pose(), base.twist()});
    const PlanningResult result = base.plan(problem);
    if (result.status != PlanningStatus::ok) ++episode.not_ok;
    if (plan_observer) plan_observer(begin, problem, result);
    const double h = period / kStepsPerPeriod;
    for (int step = 1; step <= kStepsPerPeriod; ++step) {
      const double time = begin + step * h;
      people.move_to(time, base.pose(), base.twist());
      base.move(h);
      walks.keep(time, people);
      judge(scene, rule, people, base.pose(), base.twist(), episode);
      diary.add(time, truth_at(scene, people, time, base.pose(), base.twist()), footprint);
      if (observer) observer(time, base.pose(), base.twist());
    }
    episode.time = begin + period;
    if ((base.pose().position() - scene.goal.position()).norm() <= rule.goal_tolerance) {
      episode.reached = true;
      episode.success = is_success(episode.reached, episode.collision ? 1 : 0);
      break;
    }
  }
  episode.rms_jerk = base.rms_jerk();
  episode.ms = base.ms();
  episode.contacts = diary.contacts();
  episode.walks = std::move(walks).take();
  return episode;
}

}  // namespace bw
