// The residual of one obstacle near one pose of the robot (theory.md 6.1, o_k), with its gradient.
#pragma once

#include <limits>

#include <Eigen/Core>

#include "components/local_planner/teb/band_options.hpp"
#include "components/model/footprint_distance.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::teb {

/// One obstacle, where it is when the robot passes point (1 - fraction) p_k + fraction p_{k+1} of the band.
struct ClearanceTerm {
  Capsule capsule;
  double fraction = 0.0;
  bool moving = false;
  double unsure = 0.0;  ///< by which the inflation distance grows [m]
  /// of a mover (local_planner/theory.md 7.10): below 1 there is inflation alone, and less of it
  double presence = 1.0;
  double wanted =
      std::numeric_limits<double>::infinity();  ///< most that is asked for [m] (narrow_passage.hpp)
};

/// Weights and distances of clearance terms; `growth` multiplies the weights in later outer iterations. Keeps
/// a reference to the footprint.
struct ClearanceModel {
  ClearanceModel(const BandOptions& options, const Footprint& footprint, double growth);

  struct Kind {
    double obstacle;   // weight, not its root
    double inflation;  // weight, not its root
    double inflation_dist;
  };
  Kind fixed, moving;
  double possible_inflation;  // weight, not its root; at most that of `moving`
  double min_dist;            // including penalty_epsilon
  double unsure_share = 1.0;  // of ClearanceTerm::unsure that counts
  const Footprint* footprint;
};

/// Root of the summed obstacle and inflation costs of the robot at `pose`: one residual of the same cost.
/// gradient: by x, y and theta, or null.
double evaluate_clearance(const ClearanceModel& model, const ClearanceTerm& term, const Pose2& pose,
                          Eigen::Vector3d* gradient);

}  // namespace bw::teb
