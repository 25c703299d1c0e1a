// The least-squares problem of one band with its obstacle association frozen: what every solver of it sees.
#pragma once

#include <array>
#include <vector>

#include "components/local_planner/teb/band_optimizer.hpp"
#include "components/local_planner/teb/segment_cost.hpp"

namespace bw::teb {

/// Cost of a band at given poses, in parts. Each is a sum of squared weighted residuals.
struct BandCost {
  double motion = 0.0;
  double obstacle = 0.0;
  double total() const { return motion + obstacle; }
};

/// Terms over the free variables of a band: x, y, theta of poses 1 .. n-2 and dt of poses 0 .. n-2.
struct BandProblem {
  BandProblem(const Band& band, const BandScene& scene, const BandOptions& options, double obstacle_growth);

  const Band& band;
  BandScene scene;
  SegmentModel segment_model;
  ClearanceModel clearance_model;
  std::vector<PoseTerms> terms;

  std::size_t segments() const { return band.size() - 1; }
  /// Segment k with its states read from `poses` (band.size() of them).
  SegmentStates segment(std::size_t k, const BandPose* poses) const;
  BandCost cost(const BandPose* poses) const;
  /// Largest diagonal entry of J'J over the free variables, x and y of a pose taken together: the scale of
  /// the damping, in every frame the same.
  double largest_information() const;
};

}  // namespace bw::teb
