// Obstacles as the band sees them, and the residual of one obstacle near one point of the band (book 6.1,
// o_k), with its gradient.
#pragma once

#include <vector>

#include "components/local_planner/teb/band.hpp"
#include "components/local_planner/teb/band_options.hpp"
#include "components/local_planner/teb/prediction_options.hpp"
#include "components/model/obstacles.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::teb {

/// All points within `radius` of the segment a-b: a point or disc has a == b.
struct Capsule {
  Vector2 a{0.0, 0.0};
  Vector2 b{0.0, 0.0};
  double radius = 0.0;
};

/// How unsure a prediction becomes with the time ahead: it widens the inflation of a mover, so that a band
/// keeps further away where that is cheap and a narrow way stays open.
struct Uncertainty {
  double factor = 0.0;  ///< standard deviations
  double growth = 0.0;  ///< of the standard deviation where the mover has none [m/s]
  double most = 0.0;    ///< [m]

  double at(const Mover& mover, double time) const;
};

/// What a band keeps clear of. Radii are grown by the radius of the robot, so that the robot is a point; those
/// of possible people were scaled by their presence before (book 7.10).
struct ObstacleField {
  std::vector<Capsule> statics;
  std::vector<Mover> movers;
  Uncertainty uncertainty;

  std::size_t size() const { return statics.size() + movers.size(); }
};

/// The `max_count` obstacles nearest to `position`; movers are kept before static ones. Unless predictions
/// are time-indexed, movers become static discs, possible people movers who stand.
ObstacleField nearby_obstacles(const StaticObstacles& statics, const std::vector<Mover>& movers,
                               const Vector2& position, double robot_radius, std::size_t max_count,
                               const PredictionOptions& prediction = {});

/// Distance [m] from a point to the capsule, negative inside, and its gradient (zero exactly on the axis).
struct Clearance {
  double distance = 0.0;
  Vector2 gradient{0.0, 0.0};
};
Clearance clearance_to(const Capsule& capsule, const Vector2& point);

/// One obstacle, where it is when the robot passes point (1 - fraction) p_k + fraction p_{k+1} of the band.
struct ClearanceTerm {
  Capsule capsule;
  double fraction = 0.0;
  bool moving = false;
  double unsure = 0.0;    ///< by which the inflation distance grows [m]
  double presence = 1.0;  ///< of a mover (book 7.10): below 1 there is inflation alone, and less of it
};

/// Weights and distances of clearance terms; `growth` multiplies the weights in later outer iterations.
struct ClearanceModel {
  ClearanceModel(const BandOptions& options, double growth);

  struct Kind {
    double obstacle;   // weight, not its root
    double inflation;  // weight, not its root
    double inflation_dist;
  };
  Kind fixed, moving;
  double possible_inflation;  // weight, not its root; at most that of `moving`
  double min_dist;            // including penalty_epsilon
};

/// Root of the summed obstacle and inflation costs: one residual of the same cost. gradient: d / d point, or
/// null.
double evaluate_clearance(const ClearanceModel& model, const ClearanceTerm& term, const Vector2& point,
                          Vector2* gradient);

/// The terms of pose k (fraction 0) and of the segment that follows it.
struct PoseTerms {
  std::vector<ClearanceTerm> at_pose;
  std::vector<ClearanceTerm> along_segment;
};

/// For every pose the nearest obstacles in reach, movers where they are at the pose's time, and as many possible
/// people, who take no place from others; between poses
/// where obstacle and robot move relative to each other by more than clearance_step. Result k belongs to pose
/// k.
std::vector<PoseTerms> associate(const Band& band, const ObstacleField& field, const BandOptions& options);

}  // namespace bw::teb
