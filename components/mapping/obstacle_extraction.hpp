// Turns the occupied cells around the robot into a few points and segments that a local planner can keep away
// from.
#pragma once

#include <cstddef>
#include <span>

#include "components/model/obstacle_rule.hpp"
#include "components/model/obstacles.hpp"
#include "components/model/occupancy_grid.hpp"
#include "runtime/base/field.hpp"

namespace bw {

struct ExtractionOptions {
  double radius = 4.0;  ///< boundary cells farther than this from the robot are left out [m]
  /// largest distance of a boundary cell's centre from its shape [cells] (set by code alone)
  double tolerance_cells = 0.5;
  /// smallest occupancy that is an obstacle (set by code alone)
  int occupied_at = 65;
  /// outline obstacles towards unknown cells too (set by code alone)
  bool face_unknown = false;

  template <class Visitor>
  void fields(Visitor& v) {
    v("radius", radius,
      {.unit = "m", .min = 0.1, .max = 50, .doc = "how far around the robot obstacles are given"});
    v.retired({"tolerance_cells", "occupied_at", "face_unknown"}, "a constant of obstacle_extraction.hpp");
  }
};

struct ExtractionResult {
  StaticObstacles obstacles;       ///< in the frame of the grid; each list nearest first
  std::size_t boundary_cells = 0;  ///< that the shapes stand for
};

/// Boundary cells (obstacle cells beside a free cell, seen along rows and columns) whose centre lies within
/// `radius` of `position` are chained to contours. A small round contour becomes a disc, others the fewest
/// segments that doubling strides find, a single cell a point. Every boundary
/// cell's centre lies within the tolerance of a shape (of its rim, for a disc). Shapes run through cell
/// centres: the surface may stand half a cell before them. With `surface`, the position of the surface in
/// each cell from its centre [cells], shapes run through those positions instead. Deterministic. A position
/// that is not finite gives nothing.
ExtractionResult extract_obstacles(const OccupancyGrid& grid, const Vector2& position,
                                   const ExtractionOptions& options,
                                   std::span<const Eigen::Vector2f> surface = {});

}  // namespace bw
