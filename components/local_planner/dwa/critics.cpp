#include "components/local_planner/dwa/critics.hpp"

#include <algorithm>
#include <cmath>

namespace bw::dwa {
namespace {

constexpr double kSlack =
    0.3;  // [m] by which cutting a corner leads further along the plan than the distance driven

}  // namespace

Course course_of(const std::vector<Pose2>& plan, const PlanningProblem& problem) {
  Course course{PlanLine(plan, problem.pose.position(), kForwardPoint)};
  course.along = course.line.nearest(problem.pose.position(), 0.0, course.line.length()).along;
  return course;
}

Critique critique(const RollOut& roll_out, const Course& course, const PlanningProblem& problem) {
  const double length = course.line.length();
  const double from = course.along - kSlack;
  const double to = course.along + roll_out.travel + kSlack;
  const Vector2 end = roll_out.end.position();
  const PlanLine::Projection projection = course.line.nearest(end, from, std::min(to, length));
  // The line goes on straight behind the goal, so that a robot which heads over it there is aligned.
  const PlanLine::Projection point =
      course.line.nearest(end + kForwardPoint * direction(roll_out.end.theta), from - kForwardPoint,
                          std::min(to, length) + kForwardPoint);
  return {.path_dist = projection.beside,
          .path_align = point.beside,
          .goal_dist = length - projection.along,
          .goal_align = std::max(0.0, length - point.along),
          .base_obstacle = obstacle_cost(roll_out.gap),
          .slowness = problem.limits.v_max - roll_out.twist.v,
          .turn_rate_change = std::abs(roll_out.twist.omega - problem.twist.omega)};
}

double obstacle_cost(double gap) {
  if (gap >= kInflationRadius) return 0.0;
  return std::exp(-kCostScaling * std::max(gap, 0.0));
}

double cost_without_align(const Critique& c, const CriticOptions& options) {
  return options.path_dist_scale * c.path_dist + options.goal_dist_scale * c.goal_dist +
         options.base_obstacle_scale * c.base_obstacle + kSpeedScale * c.slowness +
         kTurnRateChangeScale * c.turn_rate_change;
}

double cost(const Critique& c, const CriticOptions& options) {
  return cost_without_align(c, options) + options.path_align_scale * c.path_align +
         options.goal_align_scale * c.goal_align;
}

}  // namespace bw::dwa
