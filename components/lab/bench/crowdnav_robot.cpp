#include "components/lab/bench/crowdnav_robot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "components/lab/bench/crowd_generator.hpp"
#include "components/lab/bench/unicycle.hpp"
#include "components/model/nearest_point.hpp"

namespace bw {
namespace {

constexpr double kTouching = 2.0 * kCrowdNavRadius;  // [m] between centres
constexpr int kTicksPerStep = 5;
constexpr int kTicksPerPeriod = 2;
constexpr int kPiecesPerTick = 5;  // straight pieces of 0.01 s: an arc at the limits leaves them by 0.01 mm
constexpr double kTick = kCrowdNavStep / kTicksPerStep;  // [s]
constexpr double kPeriod = kTicksPerPeriod * kTick;      // [s] between plans
constexpr double kFar = std::numeric_limits<double>::infinity();

class HolonomicOrca final : public CrowdNavRobot {
 public:
  HolonomicOrca(const CrowdNavScene& scene, double safety_space, CpuClock clock)
      : agent_{scene.start.position(), {0.0, 0.0}},
        heading_(scene.start.theta),
        goal_(scene.goal),
        safety_space_(safety_space),
        clock_(std::move(clock)) {}

  Pose2 pose() const override { return {agent_.position.x(), agent_.position.y(), heading_}; }
  CrowdNavAgent agent() const override { return agent_; }

  double step(const std::vector<CrowdNavAgent>& people, const std::vector<Vector2>&) override {
    const double before = clock_();
    const Vector2 action = crowdnav_orca(agent_, goal_, people, safety_space_);
    took(clock_() - before);
    double gap = kFar;
    for (const CrowdNavAgent& p : people)
      gap = std::min(gap, closest_approach(p.position - agent_.position, p.velocity - action, kCrowdNavStep) -
                              kTouching);
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
  double safety_space_;
  CpuClock clock_;
  std::vector<Vector2> accelerations_;
};

class PlannerRobot final : public CrowdNavRobot {
 public:
  PlannerRobot(const CrowdNavScene& scene, LocalPlanner& planner, CpuClock clock)
      : pose_(scene.start),
        planner_(planner),
        clock_(std::move(clock)),
        limits_(crowd_rules().limits),
        plan_{scene.start, {scene.goal.x(), scene.goal.y(), scene.start.theta}},
        motion_{{0.0, scene.start, {}}} {}

  Pose2 pose() const override { return pose_; }
  CrowdNavAgent agent() const override { return {pose_.position(), twist_.v * direction(pose_.theta)}; }

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

  double rms_jerk() const override { return bw::rms_jerk(accelerations_, kPeriod); }
  std::vector<possible::MotionState> motion() const override { return motion_; }

 private:
  void replan(const std::vector<CrowdNavAgent>& people) {
    PlanningProblem problem;
    problem.now = Time::seconds(1.0 + (ticks_ - 1) * kTick);
    problem.pose = pose_;
    problem.twist = twist_;
    problem.plan = plan_;
    problem.footprint.radius = kCrowdNavRadius;
    problem.limits = limits_;
    problem.control_period = kPeriod;
    for (const CrowdNavAgent& person : people) {
      Mover mover;
      mover.id = static_cast<std::uint32_t>(problem.movers.size()) + 1;
      mover.position = person.position;
      mover.velocity = person.velocity;
      mover.radius = kCrowdNavRadius;
      problem.movers.push_back(mover);
    }
    const double before = clock_();
    const Twist2 command = planner_.plan(problem).command;
    took(clock_() - before);
    const Twist2 last = twist_;
    twist_ = applied_twist(command, last, limits_, kPeriod);
    accelerations_.push_back((twist_.v - last.v) / kPeriod);
  }

  // Moves robot and people; the least gap on the way.
  double drive_piece(std::vector<CrowdNavAgent>& people) {
    constexpr double h = kTick / kPiecesPerTick;
    const Pose2 next = unicycle_step(pose_, twist_, h);
    const Vector2 velocity = (next.position() - pose_.position()) / h;
    double gap = kFar;
    for (CrowdNavAgent& p : people) {
      gap = std::min(gap,
                     closest_approach(p.position - pose_.position(), p.velocity - velocity, h) - kTouching);
      p.position += h * p.velocity;
    }
    pose_ = next;
    motion_.push_back({static_cast<double>(motion_.size()) * h, pose_, twist_});
    return gap;
  }

  Pose2 pose_;
  Twist2 twist_;
  LocalPlanner& planner_;
  CpuClock clock_;
  Limits limits_;
  std::vector<Pose2> plan_;
  std::vector<possible::MotionState> motion_;
  int ticks_ = 0;  // so far
  std::vector<double> accelerations_;
};

}  // namespace

double closest_approach(const Vector2& offset, const Vector2& velocity, double duration) {
  return nearest_point(Segment{offset, offset + duration * velocity}, Vector2(0.0, 0.0)).norm();
}

std::unique_ptr<CrowdNavRobot> holonomic_orca_robot(const CrowdNavScene& scene, double safety_space,
                                                    const CpuClock& clock) {
  return std::make_unique<HolonomicOrca>(scene, safety_space, clock);
}

std::unique_ptr<CrowdNavRobot> planner_robot(const CrowdNavScene& scene, LocalPlanner& planner,
                                             const CpuClock& clock) {
  return std::make_unique<PlannerRobot>(scene, planner, clock);
}

}  // namespace bw
