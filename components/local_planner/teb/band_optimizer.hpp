// Optimises one timed elastic band among obstacles: damped Gauss-Newton in Ceres over (x, y, theta, dt) of
// every pose. No state of its own: candidates may be optimised in parallel, each with its own Band.
#pragma once

#include <limits>

#include "components/local_planner/teb/band.hpp"
#include "components/local_planner/teb/band_options.hpp"
#include "components/local_planner/teb/obstacle_field.hpp"
#include "components/model/limits.hpp"

namespace bw::teb {

/// What a band is optimised for. The first pose of the band is the robot, the last one the goal; both stay.
struct BandScene {
  Limits limits;
  Twist2 start_twist;
  bool goal_at_rest = true;
  const ObstacleField* obstacles = nullptr;
};

struct BandReport {
  bool usable = false;    ///< finite, and the solver did not fail
  bool finished = false;  ///< no solve of its plan is left: only then does `cost` compare with that of others
  /// For the choice: sum of squared weighted residuals, without growth of the obstacle weights, and with the
  /// share Uncertainty::in_choice of what unsure predictions cost.
  double cost = 0.0;
  double obstacle_cost = 0.0;  ///< the part of `cost` that obstacles cause
  int iterations = 0;
  std::size_t left_out =
      0;  ///< times that an obstacle which costs something near a pose found no place there
};

/// How much is done for a band.
struct Effort {
  int max_iterations = 0;
  int first_round = 0;                               ///< solves of a first plan made already
  int last_round = std::numeric_limits<int>::max();  ///< after which it is left for now
  /// BandReport::cost of another band: a solve ends that stays above.
  double rival = std::numeric_limits<double>::infinity();
};

/// A band with trust_radius 0 gets the outer and inner iterations of a first plan, any other those of a warm
/// start; one that has had some of the solves of its first plan gets the others. At most `max_iterations`
/// solver iterations are spent.
BandReport optimize(Band& band, const BandScene& scene, const BandOptions& options, const Effort& effort);
inline BandReport optimize(Band& band, const BandScene& scene, const BandOptions& options,
                           int max_iterations) {
  return optimize(band, scene, options, Effort{.max_iterations = max_iterations});
}

}  // namespace bw::teb
