// What the end of a roll-out costs (theory.md 5.9): path, goal, obstacles, speed.
#pragma once

#include <vector>

#include "components/local_planner/dwa/critic_options.hpp"
#include "components/local_planner/dwa/roll_out.hpp"
#include "components/local_planner/plan_line.hpp"

namespace bw::dwa {

/// Each the larger the worse, before the scales.
struct Critique {
  double path_dist = 0.0;         ///< from the plan to the end of the roll-out [m]
  double path_align = 0.0;        ///< from the plan to a point before the robot there [m]
  double goal_dist = 0.0;         ///< distance that is left along the plan [m]
  double goal_align = 0.0;        ///< the same of the point before the robot [m]
  double base_obstacle = 0.0;     ///< from 0, nothing near, to 1, contact
  double slowness = 0.0;          ///< below v_max [m/s]
  double turn_rate_change = 0.0;  ///< against the present turn rate [rad/s]
};

/// The plan and where on it the robot is [m].
struct Course {
  PlanLine line;
  double along = 0.0;
};

/// `plan` is not empty.
Course course_of(const std::vector<Pose2>& plan, const PlanningProblem& problem);

/// A position on the plan counts as near to the end of a roll-out only if the path driven can have led so far
/// along it: where the plan comes back on the other side of a wall is no shortcut.
Critique critique(const RollOut& roll_out, const Course& course, const PlanningProblem& problem);

/// exp(-kCostScaling gap), as costmaps are inflated; 0 from kInflationRadius on.
double obstacle_cost(double gap);

/// Weighted sum of what is left when another guide has taken the place of the aligning terms.
double cost_without_align(const Critique& critique, const CriticOptions& options);
/// Weighted sum of all.
double cost(const Critique& critique, const CriticOptions& options);

}  // namespace bw::dwa
