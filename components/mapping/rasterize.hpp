// Draws shapes into a grid so that no part of a shape lies in a cell left free.
#pragma once

#include <vector>

#include "components/model/obstacles.hpp"
#include "components/model/occupancy_grid.hpp"

namespace bw {

/// Every cell that holds a point of the convex polygon with these corners (in order; two make a segment, one
/// a point) becomes occupied. Parts outside the grid are left out, and so is a shape with a number that is
/// not finite.
void draw_convex(OccupancyGrid& grid, const std::vector<Vector2>& corners);

inline void draw_segment(OccupancyGrid& grid, const Segment& segment) {
  draw_convex(grid, {segment.a, segment.b});
}

/// As the polygon of 16 edges around it, 2 % of the radius too large at its corners.
void draw_disc(OccupancyGrid& grid, const Disc& disc);

/// Axis-aligned box with these opposite corners.
inline void draw_box(OccupancyGrid& grid, const Vector2& a, const Vector2& b) {
  draw_convex(grid, {a, {b.x(), a.y()}, b, {a.x(), b.y()}});
}

}  // namespace bw
