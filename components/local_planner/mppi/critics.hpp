// What each sampled motion costs: the critics of Nav2's parameter file (theory.md 5.8), one function each.
// All of them add to `costs`, one for each sample. Poses are in base_link of now.
#pragma once

#include <Eigen/Core>

#include "components/local_planner/mppi/costmap.hpp"
#include "components/local_planner/mppi/critic_options.hpp"
#include "components/local_planner/mppi/local_path.hpp"
#include "components/local_planner/mppi/rollouts.hpp"
#include "components/model/limits.hpp"

namespace bw::mppi {

/// What the critics know beside the motions.
struct CriticScene {
  Pose2 goal;                  ///< in base_link
  double goal_distance = 0.0;  ///< from the robot [m]; infinite when the end of the plan is not the goal
  const LocalPath& path;
  const Costmap& costmap;
  const PredictedCosts& predicted;
  const Limits& limits;
  double dt = 0.05;           ///< of a step [s]
  Eigen::Index furthest = 0;  ///< furthest_reached() of the motions
};

/// weight times the distance [m] driven faster than the limits.
void add_constraint_cost(const ConstraintOptions& options, const CriticScene& scene, const Rollouts& motions,
                         Eigen::ArrayXd& costs);

/// weight / 254 times the mean cost of the poses in the costmap; kCollisionCost for a motion that touches
/// something.
/// Returns how many do not.
Eigen::Index add_cost_cost(const CostOptions& options, const CriticScene& scene, const Rollouts& motions,
                           Eigen::ArrayXd& costs);

/// weight times the mean distance to the goal [m].
void add_goal_cost(const GoalOptions& options, const CriticScene& scene, const Rollouts& motions,
                   Eigen::ArrayXd& costs);

/// weight times the mean difference to the heading of the goal [rad].
void add_goal_angle_cost(const GoalAngleOptions& options, const CriticScene& scene, const Rollouts& motions,
                         Eigen::ArrayXd& costs);

/// weight times the mean distance [m] to the point of the plan that is as far along it as the pose is along
/// its motion; points that are taken do not count.
void add_path_align_cost(const PathAlignOptions& options, const CriticScene& scene, const Rollouts& motions,
                         Eigen::ArrayXd& costs);

/// weight times the distance [m] from the end of the motion to the first free point of the plan beyond the
/// furthest.
void add_path_follow_cost(const PathFollowOptions& options, const CriticScene& scene, const Rollouts& motions,
                          Eigen::ArrayXd& costs);

/// weight times the angle [rad] between the last heading and the direction from there to a point of the plan.
void add_path_angle_cost(const PathAngleOptions& options, const CriticScene& scene, const Rollouts& motions,
                         Eigen::ArrayXd& costs);

/// weight times the distance driven back [m].
void add_prefer_forward_cost(const PreferForwardOptions& options, const CriticScene& scene,
                             const Rollouts& motions, Eigen::ArrayXd& costs);

}  // namespace bw::mppi
