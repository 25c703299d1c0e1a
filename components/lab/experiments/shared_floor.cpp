#include "components/lab/experiments/shared_floor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "components/model/differential_drive.hpp"

namespace bw {
namespace {

bool sees(const FloorRobot& robot, const FloorRobot& other, const FloorRules& rules) {
  const Vector2 to = other.pose.position() - robot.pose.position();
  if (to.norm() > rules.view_range) return false;
  return std::abs(wrap_angle(std::atan2(to.y(), to.x()) - robot.pose.theta)) <= rules.view_angle / 2.0;
}

PlanningProblem problem_of(std::size_t index, const std::vector<FloorRobot>& robots, const FloorRules& rules,
                           double time) {
  const FloorRobot& robot = robots[index];
  PlanningProblem problem;
  problem.now = Time::seconds(1.0 + time);
  problem.pose = robot.pose;
  problem.twist = robot.twist;
  problem.plan = {robot.pose, robot.goal};
  problem.goal_tolerance.xy = rules.goal_radius;
  problem.footprint.radius = rules.radius;
  problem.limits = rules.limits;
  problem.control_period = rules.control_period;
  problem.command_lead = rules.control_period;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (i == index || !sees(robot, robots[i], rules)) continue;
    Mover mover;
    mover.id = static_cast<std::uint32_t>(i);
    mover.position = robots[i].pose.position();
    mover.velocity = robots[i].twist.v * direction(robots[i].pose.theta);
    mover.radius = rules.radius;
    mover.reciprocal = robot.runs_hrvo && robots[i].runs_hrvo;
    problem.movers.push_back(mover);
  }
  return problem;
}

double gap(const FloorRobot& a, const FloorRobot& b, const FloorRules& rules) {
  return (a.pose.position() - b.pose.position()).norm() - 2.0 * rules.radius;
}

double gap_of_first(const std::vector<FloorRobot>& robots, const FloorRules& rules) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < robots.size(); ++i)
    smallest = std::min(smallest, gap(robots[0], robots[i], rules));
  return smallest;
}

std::vector<Vector2> positions_of(const std::vector<FloorRobot>& robots) {
  std::vector<Vector2> positions;
  for (const FloorRobot& robot : robots) positions.push_back(robot.pose.position());
  return positions;
}

double gap_of_others(const std::vector<FloorRobot>& robots, const FloorRules& rules) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < robots.size(); ++i) {
    for (std::size_t j = i + 1; j < robots.size(); ++j)
      smallest = std::min(smallest, gap(robots[i], robots[j], rules));
  }
  return smallest;
}

}  // namespace

FloorRun run_on_floor(std::vector<FloorRobot> robots, const FloorRules& rules) {
  FloorRun run;
  run.smallest_gap = gap_of_first(robots, rules);
  run.smallest_other_gap = gap_of_others(robots, rules);
  const double step = rules.control_period / rules.steps_per_period;
  const int cycles = static_cast<int>(std::lround(rules.timeout / rules.control_period));
  double travelled = 0.0;
  for (int cycle = 0; cycle < cycles; ++cycle) {
    const double begin = cycle * rules.control_period;
    std::vector<Twist2> commands;
    for (std::size_t i = 0; i < robots.size(); ++i) {
      const PlanningResult result = robots[i].planner->plan(problem_of(i, robots, rules, begin));
      if (i == 0 && result.status != PlanningStatus::ok) ++run.not_ok;
      commands.push_back(result.command);
    }
    for (std::size_t i = 0; i < robots.size(); ++i) robots[i].twist = commands[i];
    run.samples.push_back({begin, commands[0].v, gap_of_first(robots, rules), positions_of(robots)});
    for (int k = 1; k <= rules.steps_per_period; ++k) {
      for (FloorRobot& robot : robots) robot.pose = advance_exact(robot.pose, robot.twist, step);
      travelled += std::abs(robots[0].twist.v) * step;
      run.time = begin + k * step;
      run.mean_speed = travelled / run.time;
      run.smallest_gap = std::min(run.smallest_gap, gap_of_first(robots, rules));
      run.smallest_other_gap = std::min(run.smallest_other_gap, gap_of_others(robots, rules));
      const double to_goal = (robots[0].goal.position() - robots[0].pose.position()).norm();
      if (run.smallest_gap < 0.0) run.outcome = FloorOutcome::contact;
      if (run.smallest_gap >= 0.0 && to_goal <= rules.goal_radius) run.outcome = FloorOutcome::reached;
      if (run.outcome == FloorOutcome::timeout) continue;
      run.samples.push_back({run.time, robots[0].twist.v, gap_of_first(robots, rules), positions_of(robots)});
      return run;
    }
  }
  return run;
}

}  // namespace bw
