// The critic of the costmap.
#include <cmath>
#include <vector>

#include "components/local_planner/mppi/critics.hpp"

namespace bw::mppi {
namespace {

constexpr double kScale = 254.0;  // of the costs in a costmap

}  // namespace

Eigen::Index add_cost_cost(const CostOptions& options, const CriticScene& scene, const Rollouts& motions,
                           Eigen::ArrayXd& costs) {
  const Eigen::Index samples = motions.samples();
  const bool near_goal = scene.goal_distance < options.kNearGoal;
  Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(samples), cost(samples);
  std::vector<char> touches(static_cast<std::size_t>(samples), 0);
  Eigen::Index looks = 0;
  for (Eigen::Index k = 0; k < motions.steps(); k += options.kPointStep, ++looks) {
    for (Eigen::Index i = 0; i < samples; ++i) cost[i] = scene.costmap.at(motions.x(i, k), motions.y(i, k));
    scene.predicted.raise(motions.x.col(k), motions.y.col(k), scene.dt * static_cast<double>(k + 1), cost);
    for (Eigen::Index i = 0; i < samples; ++i) {
      if (cost[i] < 1.0) continue;
      if (cost[i] >= kInscribed) {
        touches[static_cast<std::size_t>(i)] = 1;
      } else if (cost[i] >= options.near_collision_cost) {
        sum[i] += options.kCriticalCost;
      } else if (!near_goal) {
        sum[i] += cost[i];
      }
    }
  }
  Eigen::Index free = 0;
  for (Eigen::Index i = 0; i < samples; ++i) {
    if (touches[static_cast<std::size_t>(i)]) {
      sum[i] = options.kCollisionCost;
    } else {
      ++free;
    }
  }
  costs += options.cost_weight / kScale / static_cast<double>(looks) * sum;
  return free;
}

}  // namespace bw::mppi
