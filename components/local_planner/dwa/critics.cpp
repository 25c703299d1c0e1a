#include "components/local_planner/dwa/critics.hpp"

#include <algorithm>
#include <cmath>

namespace bw::dwa {
namespace {

constexpr double kSlack =
    0.3;  // [m] by which cutting a corner leads further along the plan than the way driven

}  // namespace

Course course_of(const std::vector<Pose2>& plan, const PlanningProblem& problem,
                 const CriticOptions& options) {
  Course course{PlanLine(plan, problem.pose.position(), options.forward_point_distance)};
  course.along = course.line.nearest(problem.pose.position(), 0.0, course.line.length()).along;
  return course;
}

Critique critique(const RollOut& roll_out, const Course& course, const PlanningProblem& problem,
                  const CriticOptions& options) {
  const double ahead = options.forward_point_distance;
  const double length = course.line.length();
  const double from = course.along - kSlack;
  const double to = course.along + roll_out.travel + kSlack;
  const Vector2 end = roll_out.end.position();
  const PlanLine::Place place = course.line.nearest(end, from, std::min(to, length));
  // The line goes on straight behind the goal, so that a robot which heads over it there is aligned.
  const PlanLine::Place point = course.line.nearest(end + ahead * direction(roll_out.end.theta), from - ahead,
                                                    std::min(to, length) + ahead);
  return {.path_dist = place.beside,
          .path_align = point.beside,
          .goal_dist = length - place.along,
          .goal_align = std::max(0.0, length - point.along),
          .base_obstacle = obstacle_cost(roll_out.gap, options),
          .slowness = problem.limits.v_max - roll_out.twist.v,
          .turn_change = std::abs(roll_out.twist.omega - problem.twist.omega)};
}

double obstacle_cost(double gap, const CriticOptions& options) {
  if (gap >= options.inflation_radius) return 0.0;
  return std::exp(-options.cost_scaling_factor * std::max(gap, 0.0));
}

double cost_without_align(const Critique& c, const CriticOptions& options) {
  return options.path_dist_scale * c.path_dist + options.goal_dist_scale * c.goal_dist +
         options.base_obstacle_scale * c.base_obstacle + options.speed_scale * c.slowness +
         options.turn_change_scale * c.turn_change;
}

double cost(const Critique& c, const CriticOptions& options) {
  return cost_without_align(c, options) + options.path_align_scale * c.path_align +
         options.goal_align_scale * c.goal_align;
}

}  // namespace bw::dwa
