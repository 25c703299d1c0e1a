#include "components/lab/bench/crowdnav_robot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "components/lab/bench/crowd_generator.hpp"
#include "components/lab/bench/planner_alone.hpp"
#include "components/lab/bench/unicycle.hpp"

namespace bw {
namespace {

constexpr int kTicksPerStep = 5;
constexpr int kTicksPerPeriod = 2;
constexpr int kPiecesPerTick = 5;  // straight pieces of 0.01 s: an arc at the limits leaves them by 0.01 mm
constexpr double kTick = kCrowdNavStep / kTicksPerStep;  // [s]
constexpr double kPeriod = kTicksPerPeriod * kTick;      // [s] between plans
constexpr double kFar = std::numeric_limits<double>::infinity();
const Vector2 kNowhere(15.0, 15.0);  // where CrowdNav++ takes those to be who were not seen yet

// Between centres where outlines touch.
double touching(const CrowdNavAgent& person) { return kCrowdNavRadius + person.radius; }

bool is_within(double range, const Vector2& robot, const CrowdNavAgent& person) {
  return (person.position - robot).norm() - touching(person) <= range;
}

class HolonomicRobot final : public CrowdNavRobot {
 public:
  HolonomicRobot(const CrowdNavScene& scene, CrowdNavPolicy policy, CpuClock clock)
      : agent_{scene.start.position(), {0.0, 0.0}},
        heading_(scene.start.theta),
        goal_(scene.goal),
        range_(scene.rules.sensed_range),
        policy_(std::move(policy)),
        clock_(std::move(clock)),
        seen_(scene.people.size(), CrowdNavAgent{.position = kNowhere}) {
    const CrowdNavPeople there(scene);
    see(there.agents());
  }

  Pose2 pose() const override { return {agent_.position.x(), agent_.position.y(), heading_}; }
  CrowdNavAgent agent() const override { return agent_; }

  void see(const std::vector<CrowdNavAgent>& people) override {
    for (std::size_t i = 0; i < people.size(); ++i) {
      if (is_within(range_, agent_.position, people[i]))
        seen_[i] = people[i];
      else
        seen_[i].position += kCrowdNavStep * seen_[i].velocity;
    }
  }

  double step(const std::vector<CrowdNavAgent>& people, const std::vector<Vector2>&) override {
    const double before = clock_();
    const Vector2 action = policy_(agent_, goal_, seen_);
    took(clock_() - before);
    double gap = kFar;
    for (const CrowdNavAgent& p : people)
      gap = std::min(gap, closest_approach(p.position - agent_.position, p.velocity - action, kCrowdNavStep) -
                              touching(p));
    accelerations_.push_back((action - agent_.velocity) / kCrowdNavStep);
    if (!action.isZero()) heading_ = std::atan2(action.y(), action.x());
    agent_.velocity = action;
    agent_.position += kCrowdNavStep * action;
    return gap;
  }

  double rms_jerk() const override {
    std::vector<double> along_x, along_y;
    for (const Vector2& a : accelerations_) {
      along_x.push_back(a.x());
      along_y.push_back(a.y());
    }
    return std::hypot(bw::rms_jerk(along_x, kCrowdNavStep), bw::rms_jerk(along_y, kCrowdNavStep));
  }

 private:
  CrowdNavAgent agent_;
  double heading_;
  Vector2 goal_;
  double range_;
  CrowdNavPolicy policy_;
  CpuClock clock_;
  std::vector<CrowdNavAgent> seen_;
  std::vector<Vector2> accelerations_;
};

class PlannerRobot final : public CrowdNavRobot {
 public:
  PlannerRobot(const CrowdNavScene& scene, LocalPlanner& planner, CpuClock clock)
      : base_(scene.start, kCrowdNavRadius, crowd_rules().limits, kPeriod,
              twice_the_limits(crowd_rules().limits, kPeriod), planner, std::move(clock)),
        range_(scene.rules.sensed_range),
        plan_{scene.start, {scene.goal.x(), scene.goal.y(), scene.start.theta}},
        motion_{{0.0, scene.start, {}}} {}

  Pose2 pose() const override { return base_.pose(); }
  CrowdNavAgent agent() const override { return {base_.pose().position(), base_.velocity()}; }

  double step(const std::vector<CrowdNavAgent>& people, const std::vector<Vector2>& velocities) override {
    double gap = kFar;
    std::vector<CrowdNavAgent> now = people;
    for (int tick = 0; tick < kTicksPerStep; ++tick) {
      if (ticks_++ % kTicksPerPeriod == 0) replan(now);
      for (std::size_t i = 0; i < now.size(); ++i) now[i].velocity = velocities[i];
      for (int piece = 0; piece < kPiecesPerTick; ++piece) gap = std::min(gap, drive_piece(now));
    }
    return gap;
  }

  double rms_jerk() const override { return base_.rms_jerk(); }
  std::vector<possible::MotionState> motion() const override { return motion_; }

 private:
  void replan(const std::vector<CrowdNavAgent>& people) {
    PlanningProblem problem = base_.problem((ticks_ - 1) * kTick, plan_);
    for (const CrowdNavAgent& person : people) {
      if (!is_within(range_, base_.pose().position(), person)) continue;
      add_mover(problem, person.id + 1, person.position, person.velocity, person.radius);
    }
    base_.plan(problem);
    took(base_.ms().back());
  }

  // Moves robot and people; the least gap on the way.
  double drive_piece(std::vector<CrowdNavAgent>& people) {
    constexpr double h = kTick / kPiecesPerTick;
    const Vector2 from = base_.pose().position();
    base_.move(h);
    const Vector2 velocity = (base_.pose().position() - from) / h;
    double gap = kFar;
    for (CrowdNavAgent& p : people) {
      gap = std::min(gap, closest_approach(p.position - from, p.velocity - velocity, h) - touching(p));
      p.position += h * p.velocity;
    }
    motion_.push_back({static_cast<double>(motion_.size()) * h, base_.pose(), base_.twist()});
    return gap;
  }

  PlannedBase base_;
  double range_;
  std::vector<Pose2> plan_;
  std::vector<possible::MotionState> motion_;
  int ticks_ = 0;  // so far
};

}  // namespace

std::unique_ptr<CrowdNavRobot> holonomic_robot(const CrowdNavScene& scene, CrowdNavPolicy policy,
                                               const CpuClock& clock) {
  return std::make_unique<HolonomicRobot>(scene, std::move(policy), clock);
}

std::unique_ptr<CrowdNavRobot> holonomic_orca_robot(const CrowdNavScene& scene, double safety_space,
                                                    const CpuClock& clock) {
  const auto policy = [safety_space, neighbours = scene.rules.neighbours](
                          const CrowdNavAgent& self, const Vector2& goal,
                          const std::vector<CrowdNavAgent>& others) {
    return crowdnav_orca(self, goal, others, safety_space, neighbours);
  };
  return holonomic_robot(scene, policy, clock);
}

std::unique_ptr<CrowdNavRobot> published_orca_robot(const CrowdNavScene& scene, const CpuClock& clock) {
  const CrowdNavScene first =
      crowdnav_scene(scene.rules.mixed ? CrowdNavCrossing::mixed_crowd : CrowdNavCrossing::crowd, 0);
  std::vector<double> radii;
  const CrowdNavPeople there(first);
  for (const CrowdNavAgent& person : there.agents())
    radii.push_back(is_within(first.rules.sensed_range, first.start.position(), person) ? person.radius
                                                                                        : kCrowdNavRadius);
  const auto policy = [radii, look = first.people.back().look, rules = scene.rules](
                          CrowdNavAgent self, const Vector2& goal, std::vector<CrowdNavAgent> others) {
    self.look = look;
    for (std::size_t i = 0; i < others.size(); ++i) others[i].radius = radii[i];
    return crowdnav_orca(self, goal, others, rules.people_margin, rules.neighbours);
  };
  return holonomic_robot(scene, policy, clock);
}

std::unique_ptr<CrowdNavRobot> planner_robot(const CrowdNavScene& scene, LocalPlanner& planner,
                                             const CpuClock& clock) {
  return std::make_unique<PlannerRobot>(scene, planner, clock);
}

}  // namespace bw
