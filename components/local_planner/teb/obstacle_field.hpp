// What a band keeps clear of.
#pragma once

#include <vector>

#include "components/local_planner/teb/prediction_options.hpp"
#include "components/model/capsule_index.hpp"
#include "components/model/footprint_distance.hpp"
#include "components/model/obstacles.hpp"

namespace bw::teb {

/// How unsure a prediction becomes with the time ahead: it widens the inflation of a mover, so that a band
/// keeps further away where that is cheap and a narrow passage stays open.
struct Uncertainty {
  double factor = 0.0;     ///< standard deviations
  double growth = 0.0;     ///< of the standard deviation where the mover has none [m/s]
  double most = 0.0;       ///< [m]
  double in_choice = 0.0;  ///< share that counts when bands are compared

  double at(const Mover& mover, double time) const;
};

/// Obstacles, and the robot that keeps clear of them. The radii of possible people are scaled by their
/// presence (local_planner/theory.md 7.10).
struct ObstacleField {
  CapsuleIndex statics;
  std::vector<Mover> movers;
  Uncertainty uncertainty;
  Footprint footprint{.radius = 0.0, .polygon = {}};
  Vector2 position{0.0,
                   0.0};  ///< of the robot: of what is equally near to a pose, the nearer to it comes first
};

/// All of them, for a robot that is at `position` now; movers that are obstacles and nothing more
/// (local_planner/theory.md 7.10) are among `statics` already. Unless predictions are time-indexed, movers
/// become static discs, possible people movers who stand.
ObstacleField field_of(const StaticObstacles& statics, const std::vector<Mover>& movers,
                       const Vector2& position, const Footprint& footprint,
                       const PredictionOptions& prediction = {});

}  // namespace bw::teb
