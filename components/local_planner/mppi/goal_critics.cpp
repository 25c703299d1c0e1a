// Critics that act near the goal.
#include <cmath>

#include "components/local_planner/mppi/critics.hpp"

namespace bw::mppi {

void add_goal_cost(const GoalOptions& options, const CriticScene& scene, const Rollouts& motions,
                   Eigen::ArrayXd& costs) {
  if (options.cost_weight <= 0.0 || scene.goal_distance > options.kWithin) return;
  const double scale = options.cost_weight / static_cast<double>(motions.steps());
  for (Eigen::Index k = 0; k < motions.steps(); ++k) {
    costs += scale *
             ((motions.x.col(k) - scene.goal.x).square() + (motions.y.col(k) - scene.goal.y).square()).sqrt();
  }
}

void add_goal_angle_cost(const GoalAngleOptions& options, const CriticScene& scene, const Rollouts& motions,
                         Eigen::ArrayXd& costs) {
  if (options.cost_weight <= 0.0 || scene.goal_distance > options.kWithin) return;
  const double scale = options.cost_weight / static_cast<double>(motions.steps());
  for (Eigen::Index k = 0; k < motions.steps(); ++k) {
    for (Eigen::Index i = 0; i < costs.size(); ++i)
      costs[i] += scale * std::abs(wrap_angle(motions.theta(i, k) - scene.goal.theta));
  }
}

}  // namespace bw::mppi
