// Which obstacles count at which pose of a band.
#pragma once

#include <vector>

#include "components/local_planner/teb/band.hpp"
#include "components/local_planner/teb/band_options.hpp"
#include "components/local_planner/teb/clearance_cost.hpp"
#include "components/local_planner/teb/obstacle_field.hpp"

namespace bw::teb {

/// The terms of pose k (fraction 0) and of the segment that follows it.
struct PoseTerms {
  std::vector<ClearanceTerm> at_pose;
  std::vector<ClearanceTerm> along_segment;
  std::size_t left_out =
      0;  ///< obstacles that cost something here and found no place (max_obstacles_per_pose)
};

/// Of all obstacles of the field those nearest to each pose: max_obstacles_per_pose static ones, as many
/// movers where they are at the pose's time, and as many possible people; again as many between poses where
/// obstacle and robot move relative to each other by more than clearance_step. Result k belongs to pose k.
/// Takes a time that does not grow with what is far from the band.
std::vector<PoseTerms> associate(const Band& band, const ObstacleField& field, const BandOptions& options);

}  // namespace bw::teb
