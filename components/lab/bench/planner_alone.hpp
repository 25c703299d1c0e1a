// What a bench asks of a planner alone: a disc on a path among others, all of them known.
#pragma once

#include <cstdint>
#include <vector>

#include "components/model/planning.hpp"

namespace bw {

/// `time` since the drive began [s]; planners' clocks begin a second before.
inline PlanningProblem problem_alone(double time, const Pose2& pose, const Twist2& twist,
                                     const std::vector<Pose2>& plan, double radius, const Limits& limits,
                                     double period) {
  PlanningProblem problem;
  problem.now = Time::seconds(1.0 + time);
  problem.pose = pose;
  problem.twist = twist;
  problem.plan = plan;
  problem.footprint.radius = radius;
  problem.limits = limits;
  problem.control_period = period;
  return problem;
}

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
