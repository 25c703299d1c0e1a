// Critics of the velocities of a motion.
#include "components/local_planner/mppi/critics.hpp"

namespace bw::mppi {

void add_constraint_cost(const ConstraintOptions& options, const CriticScene& scene, const Rollouts& motions,
                         Eigen::ArrayXd& costs) {
  if (options.cost_weight <= 0.0) return;
  const double scale = options.cost_weight * scene.dt;
  for (Eigen::Index k = 0; k < motions.steps(); ++k) {
    const auto v = motions.v.col(k);
    costs += scale * ((v - scene.limits.v_max).max(0.0) + (-scene.limits.v_back_max - v).max(0.0));
  }
}

void add_prefer_forward_cost(const PreferForwardOptions& options, const CriticScene& scene,
                             const Rollouts& motions, Eigen::ArrayXd& costs) {
  if (options.cost_weight <= 0.0 || scene.goal_distance < options.kBeyond) return;
  const double scale = options.cost_weight * scene.dt;
  for (Eigen::Index k = 0; k < motions.steps(); ++k) costs += scale * (-motions.v.col(k)).max(0.0);
}

}  // namespace bw::mppi
