// One band that is considered: optimised, checked and compared with the others.
#pragma once

#include <string>
#include <vector>

#include "components/local_planner/driving.hpp"
#include "components/local_planner/teb/band_optimizer.hpp"
#include "components/model/planning.hpp"

namespace bw::teb {

struct BandCandidate {
  Band band;
  std::string label;        ///< where it came from, for people
  bool kept = false;        ///< a band of the last cycle
  bool spare = false;       ///< was one too many then: goes on only where its topology is looked for again
  bool driven = false;      ///< the one the robot followed in the last cycle
  bool settled = false;     ///< was a kept band already when it was chosen: its cost had converged
  bool along_plan = false;  ///< begun along the plan: the others are compared with what it comes to
  bool evasive = false;     ///< goes on from an evasive move, not optimised since

  // Of improve():
  BandReport report;
  std::vector<TrajectoryPoint> trajectory;
  Safety safety;
  double cost = 0.0;  ///< what selection compares (3.10): report.cost and what a planner adds
};

/// Makes its trajectory and checks that; `report` is left alone.
void check(BandCandidate& candidate, const PlanningProblem& problem, const DrivingOptions& driving);

/// Optimises the band of `candidate` and checks it.
void improve(BandCandidate& candidate, const PlanningProblem& problem, const ObstacleField& field,
             const BandOptions& options, const DrivingOptions& driving, const Effort& effort);

}  // namespace bw::teb
