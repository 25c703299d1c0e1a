// A planner alone, as benches drive it: a disc on a path among others, all of them known; the ideal base does what it says
// within its limits. Metres, seconds.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "components/lab/bench/bench_common.hpp"
#include "components/lab/bench/unicycle.hpp"
#include "components/model/planning.hpp"

namespace bw {

class PlannedBase {
 public:
  /// `period`: between plans [s], by which the twist changes by at most `change`. `planner` must outlive it, and should be
  /// new: it keeps its warm start.
  PlannedBase(const Pose2& start, double radius, const Limits& limits, double period,
              const TwistChange& change, LocalPlanner& planner, CpuClock clock)
      : pose_(start),
        radius_(radius),
        limits_(limits),
        period_(period),
        change_(change),
        planner_(planner),
        clock_(std::move(clock)) {}

  /// What it is asked without the others; `time` since the drive began, planners' clocks begin a second before.
  PlanningProblem problem(double time, const std::vector<Pose2>& path) const {
    PlanningProblem problem;
    problem.now = Time::seconds(1.0 + time);
    problem.pose = pose_;
    problem.twist = twist_;
    problem.plan = path;
    problem.footprint.radius = radius_;
    problem.limits = limits_;
    problem.control_period = period_;
    return problem;
  }

  /// Asks, and drives the command from now on.
  PlanningResult plan(const PlanningProblem& problem) {
    const double before = clock_();
    PlanningResult result = planner_.plan(problem);
    ms_.push_back(clock_() - before);
    const Twist2 last = twist_;
    twist_ = applied_twist(result.command, last, limits_, change_);
    accelerations_.push_back((twist_.v - last.v) / period_);
    return result;
  }

  void move(double h) { pose_ = unicycle_step(pose_, twist_, h); }

  const Pose2& pose() const { return pose_; }
  const Twist2& twist() const { return twist_; }
  Vector2 velocity() const { return twist_.v * direction(pose_.theta); }
  /// CPU time of every plan.
  const std::vector<double>& ms() const { return ms_; }
  /// Of what was driven so far [m/s^3].
  double rms_jerk() const { return bw::rms_jerk(accelerations_, period_); }

 private:
  Pose2 pose_;
  Twist2 twist_;
  double radius_;
  Limits limits_;
  double period_;
  TwistChange change_;
  LocalPlanner& planner_;
  CpuClock clock_;
  std::vector<double> ms_;
  std::vector<double> accelerations_;
};

inline void add_mover(PlanningProblem& problem, std::uint32_t id, const Vector2& position,
                      const Vector2& velocity, double radius) {
  Mover mover;
  mover.id = id;
  mover.position = position;
  mover.velocity = velocity;
  mover.radius = radius;
  problem.movers.push_back(mover);
}

}  // namespace bw
