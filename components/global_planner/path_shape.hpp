// From a staircase of cells to a path a robot likes to follow.
#pragma once

#include <vector>

#include "components/global_planner/astar.hpp"
#include "runtime/base/pose2.hpp"

namespace bw {

/// What a straight line meets on the grid.
struct LineOfSight {
  bool free =
      false;  ///< no blocked cell is touched; where the line passes a corner, both cells beside it are free
  double cost = 0.0;       ///< integral of cell cost over length [free metres]
  float clearance = 0.0F;  ///< smallest clearance of the cells passed [m]
};

LineOfSight line_of_sight(const SearchGrid& grid, const Vector2& from, const Vector2& to);

/// Corners of a path along `path` from `start` to `goal`, points in its first and last cell. A straight line
/// replaces a piece of the path only where it is free, costs no more than the piece and comes no closer to
/// obstacles (by more than a cell).
std::vector<Vector2> shorten(const SearchGrid& grid, const GridPath& path, const Vector2& start,
                             const Vector2& goal);

/// Poses every `spacing` [m] at most along the corners, each heading along its line; the last one is
/// `goal_heading`.
std::vector<Pose2> sample(const std::vector<Vector2>& corners, double spacing, double goal_heading);

}  // namespace bw
