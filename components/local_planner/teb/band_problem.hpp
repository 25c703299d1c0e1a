// The least-squares problem of one band with its obstacle association frozen: what every solver of it sees.
#pragma once

#include <vector>

#include "components/local_planner/teb/association.hpp"
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

  std::size_t poses;
  BandScene scene;
  SegmentModel segment_model;
  ClearanceModel clearance_model;
  std::vector<PoseTerms> terms;

  std::size_t segments() const { return poses - 1; }
  /// Of a band at as many poses.
  BandCost cost(const BandPose* at) const;
};

}  // namespace bw::teb
