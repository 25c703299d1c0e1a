#include "components/local_planner/teb/clearance_cost.hpp"

#include <algorithm>
#include <cmath>

namespace bw::teb {

ClearanceModel::ClearanceModel(const BandOptions& options, const Footprint& the_footprint, double growth)
    : fixed{options.weights.obstacle * growth, options.weights.inflation, options.inflation_dist},
      moving{options.weights.dynamic_obstacle * growth, options.weights.dynamic_inflation,
             options.dynamic_obstacle_inflation_dist},
      possible_inflation(std::min(options.weights.kPossibleInflation, options.weights.dynamic_inflation)),
      min_dist(options.min_obstacle_dist + options.penalty_epsilon),
      footprint(&the_footprint) {}

double evaluate_clearance(const ClearanceModel& model, const ClearanceTerm& term, const Pose2& pose,
                          Eigen::Vector3d* gradient) {
  const ClearanceModel::Kind& kind = term.moving ? model.moving : model.fixed;
  const Footprint& footprint = *model.footprint;
  const double s = term.presence;
  const double wanted = std::min(model.min_dist, term.wanted);
  const double inflated_to = s * (kind.inflation_dist + model.unsure_share * term.unsure);
  if (gradient != nullptr) gradient->setZero();
  // Most terms are out of reach: of a polygon the disc around it tells, which takes less time.
  const Capsule& obstacle_at = term.capsule;
  FootprintDistance clearance =
      distance_to(pose.position(), {obstacle_at.a, obstacle_at.b, obstacle_at.radius + footprint.radius});
  if (clearance.distance >= std::max(wanted, inflated_to)) return 0.0;
  if (footprint.is_polygon()) clearance = distance_to(footprint, pose, obstacle_at);
  const double close = std::max(0.0, wanted - clearance.distance);
  const double inflated = std::max(0.0, inflated_to - clearance.distance);
  // Of possible people only the inflation counts: what is to be kept from is among the static obstacles.
  const double stiffer = wanted < model.min_dist ? model.min_dist / wanted : 1.0;
  const double obstacle = s < 1.0 ? 0.0 : kind.obstacle * stiffer * stiffer;
  const double inflation = s < 1.0 ? s * model.possible_inflation : kind.inflation;
  const double cost = obstacle * close * close + inflation * inflated * inflated;
  if (cost <= 0.0) return 0.0;
  const double residual = std::sqrt(cost);
  if (gradient != nullptr) {
    const double slope = -(obstacle * close + inflation * inflated) / residual;
    *gradient = {clearance.gradient.x() * slope, clearance.gradient.y() * slope, clearance.by_theta * slope};
  }
  return residual;
}

}  // namespace bw::teb
