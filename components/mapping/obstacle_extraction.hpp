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
  double radius = 4.0;           ///< boundary cells farther than this from the robot are left out [m]
  double tolerance_cells = 0.5;  ///< largest distance of a boundary cell's centre from its shape [cells]
  int occupied_at = 65;          ///< smallest occupancy that is an obstacle
  bool face_unknown = false;     ///< outline obstacles towards unknown cells too

  template <class Visitor>
  void fields(Visitor& v) {
    v("radius", radius,
      {.unit = "m", .min = 0.1, .max = 50, .doc = "how far around the robot obstacles are given"});
    v("tolerance_cells", tolerance_cells,
      {.unit = "cells",
       .min = 0.1,
       .max = 2,
       .doc = "how closely segments follow the cells; raise it for fewer"});
    v("occupied_at", occupied_at,
      {.min = 1, .max = 100, .doc = "smallest occupancy of a map cell that is an obstacle"});
    v("face_unknown", face_unknown,
      {.doc = "outline obstacles towards unknown cells too; for robots that enter them"});
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
/// centres: the surface may stand half a cell before them. With `surface`, the place of the surface in each
/// cell from its centre [cells], shapes run through those places instead. Deterministic. A position that is
/// not finite gives nothing.
ExtractionResult extract_obstacles(const OccupancyGrid& grid, const Vector2& position,
                                   const ExtractionOptions& options,
                                   std::span<const Eigen::Vector2f> surface = {});

}  // namespace bw
