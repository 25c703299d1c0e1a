// Draws shapes into a grid so that every cell that holds a part of a shape takes its value.
#pragma once

#include <cstdint>
#include <vector>

#include "components/model/obstacles.hpp"
#include "components/model/occupancy_grid.hpp"

namespace bw {

/// Every cell that holds a point of the convex polygon with these corners (in order; two make a segment, one
/// a point) becomes occupied, or what `value` says. Parts outside the grid are left out, and so is a shape
/// with a number that is not finite.
void draw_convex(OccupancyGrid& grid, const std::vector<Vector2>& corners,
                 std::int8_t value = OccupancyGrid::kOccupied);

inline void draw_segment(OccupancyGrid& grid, const Segment& segment,
                         std::int8_t value = OccupancyGrid::kOccupied) {
  draw_convex(grid, {segment.a, segment.b}, value);
}

/// The same for any polygon, closed from the last corner to the first. It may cross itself, as a line drawn
/// by hand does: all that it goes round is inside.
void draw_polygon(OccupancyGrid& grid, const std::vector<Vector2>& corners, std::int8_t value);

/// Makes the grid larger by whole cells, which are unknown, so that it holds these points (finite). False,
/// and nothing is changed, when it had more than `max_cells` then.
bool grow_to_hold(OccupancyGrid& grid, const std::vector<Vector2>& points, double max_cells);

/// As the polygon of 16 edges around it, 2 % of the radius too large at its corners.
void draw_disc(OccupancyGrid& grid, const Disc& disc);

/// Axis-aligned box with these opposite corners.
inline void draw_box(OccupancyGrid& grid, const Vector2& a, const Vector2& b) {
  draw_convex(grid, {a, {b.x(), a.y()}, b, {a.x(), b.y()}});
}

}  // namespace bw
