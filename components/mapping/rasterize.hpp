// Draws shapes into a grid so that no part of a shape lies in a cell left free.
#pragma once

#include "components/model/obstacles.hpp"
#include "components/model/occupancy_grid.hpp"

namespace bw {

/// Every cell that holds a point of the segment becomes occupied; parts outside the grid are left out.
void draw_segment(OccupancyGrid& grid, const Segment& segment);

/// Every cell that holds a point of the axis-aligned box with these opposite corners becomes occupied.
void draw_box(OccupancyGrid& grid, const Vector2& corner, const Vector2& opposite);

}  // namespace bw
