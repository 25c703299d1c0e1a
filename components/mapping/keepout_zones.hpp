// Nav2's keepout filter: a mask over the map, in whose occupied cells no part of the robot may be.
#pragma once

#include <string>

#include "components/mapping/obstacle_extraction.hpp"
#include "components/model/obstacles.hpp"
#include "components/model/occupancy_grid.hpp"

namespace bw {

/// Mask and map may differ in frame, extents and resolution. Cells that are unknown or below 65 keep nobody
/// out, and neither does what lies beyond the mask. X_KF is a frame F as seen from the mask's.
class KeepoutZones {
 public:
  /// Returns why the mask is none (a cell that is neither -1 nor from 0 to 100), and then those before stay;
  /// or nothing. Its sizes and numbers must be good.
  std::string set_mask(const OccupancyGrid& mask);

  bool empty() const { return !has_zones_; }
  /// Whether a point of the mask's frame lies in a zone.
  bool hold(const Vector2& point) const;

  /// Occupies the cells of `grid`, in F, whose centre lies in a zone, and those that a zone's cell has its
  /// centre in: so that none falls between the cells of a coarser grid.
  void mark(OccupancyGrid& grid, const Pose2& X_KF) const;

  /// Appends the outlines near `position`, all in F, as extract_obstacles() gives them of a map. To a robot
  /// that stands in a zone its place is an obstacle: it is to stay where it is.
  void add_to(StaticObstacles& obstacles, const Vector2& position, const Pose2& X_KF,
              const ExtractionOptions& options) const;

 private:
  OccupancyGrid cells_;  ///< kFree or kOccupied; one free cell more all round, so that zones at the rim have
                         ///< outlines
  bool has_zones_ = false;
};

}  // namespace bw
