// A planner in closed loop with an ideal unicycle that takes its commands as they are.
#pragma once

#include <algorithm>
#include <vector>

#include "components/local_planner/footprint_check.hpp"
#include "components/model/differential_drive.hpp"
#include "components/model/planning.hpp"

namespace bw {

struct Drive {
  std::vector<Pose2> poses;
  std::vector<Twist2> twists;
  std::vector<PlanningStatus> statuses;
  double smallest_gap = 1e9;
};

inline Drive drive(LocalPlanner& planner, PlanningProblem problem, int cycles) {
  Drive result;
  for (int i = 0; i < cycles; ++i) {
    const PlanningResult plan = planner.plan(problem);
    problem.twist = plan.command;
    problem.pose = advance_exact(problem.pose, plan.command, problem.control_period);
    problem.now = problem.now + Duration::seconds(problem.control_period);
    for (Mover& m : problem.movers) m.position += problem.control_period * m.velocity;
    result.poses.push_back(problem.pose);
    result.twists.push_back(plan.command);
    result.statuses.push_back(plan.status);
    result.smallest_gap = std::min(
        result.smallest_gap, gap_at(problem.pose, 0.0, problem.footprint, problem.obstacles, problem.movers));
  }
  return result;
}

inline PlanningProblem problem_to(const Pose2& goal) {
  PlanningProblem problem;
  problem.now = Time::seconds(1.0);
  problem.plan = {{0, 0, 0}, goal};
  return problem;
}

/// Within twice the default tolerance, where an arrived robot stays, and standing.
inline bool is_at_rest_at(const Pose2& goal, const Drive& drive) {
  const Pose2& end = drive.poses.back();
  return (end.position() - goal.position()).norm() <= 0.2 &&
         std::abs(wrap_angle(end.theta - goal.theta)) <= 0.12 && drive.twists.back() == Twist2{};
}

}  // namespace bw
