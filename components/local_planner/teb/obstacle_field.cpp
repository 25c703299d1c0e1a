#include "components/local_planner/teb/obstacle_field.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "components/model/mover_weight.hpp"

namespace bw::teb {
namespace {

// As time_indexed sees them, if they stood at their present and, if asked, at one future position.
void add_standing(const Mover& mover, const PredictionOptions& prediction, std::vector<Mover>& movers) {
  const auto add = [&](const Vector2& position) {
    movers.push_back(mover);
    movers.back().position = position;
    movers.back().velocity = {0.0, 0.0};
    movers.back().predictions.clear();
  };
  add(mover.position);
  if (prediction.prediction == Prediction::doubled) add(mover.position_at(prediction.prediction_time));
}

// By the distance from the robot first, and told apart by all in which they can differ: sums over them do not
// hang on the order given.
auto order_of(const Mover& m, const Vector2& robot) {
  return std::tuple((m.position - robot).norm() - m.radius, m.position.x(), m.position.y(), m.velocity.x(),
                    m.velocity.y(), m.radius, m.confidence, m.id);
}

std::vector<Mover> nearest_first(const std::vector<Mover>& movers, const Vector2& robot) {
  std::vector<std::pair<decltype(order_of(movers.front(), robot)), std::size_t>> order;
  order.reserve(movers.size());
  for (std::size_t i = 0; i < movers.size(); ++i) order.emplace_back(order_of(movers[i], robot), i);
  std::sort(order.begin(), order.end());
  std::vector<Mover> sorted;
  sorted.reserve(order.size());
  for (const auto& [unused, i] : order) {
    sorted.push_back(movers[i]);
    sorted.back().radius = present_radius(movers[i]);
  }
  return sorted;
}

}  // namespace

double Uncertainty::at(const Mover& mover, double time) const {
  if (factor <= 0.0) return 0.0;
  const double sigma = mover.predictions.empty() ? growth * time : mover.sigma_at(time);
  return std::min(most, factor * sigma);
}

ObstacleField field_of(const StaticObstacles& statics, const std::vector<Mover>& movers,
                       const Vector2& position, const Footprint& footprint,
                       const PredictionOptions& prediction) {
  ObstacleField field;
  field.uncertainty = {prediction.uncertainty_factor, prediction.uncertainty_growth,
                       prediction.max_uncertainty, prediction.uncertainty_in_choice};
  field.footprint = footprint;
  field.position = position;
  const bool time_indexed = prediction.prediction == Prediction::time_indexed;
  std::vector<Mover> moving;
  std::vector<Capsule> capsules = capsules_of(statics);
  for (const Mover& m : movers) {
    if (presence(m) == 0.0) continue;
    if (time_indexed) {
      moving.push_back(m);
    } else if (!is_confirmed(m)) {
      add_standing(m, prediction, moving);
    } else {
      capsules.push_back({m.position, m.position, m.radius});
      if (prediction.prediction != Prediction::doubled) continue;
      const Vector2 then = m.position_at(prediction.prediction_time);
      capsules.push_back({then, then, m.radius + field.uncertainty.at(m, prediction.prediction_time)});
    }
  }
  field.statics = CapsuleIndex(std::move(capsules));
  field.movers = nearest_first(moving, position);
  return field;
}

}  // namespace bw::teb
