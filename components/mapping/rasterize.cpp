#include "components/mapping/rasterize.hpp"

#include <algorithm>
#include <cmath>

namespace bw {
namespace {

// Column or row of coordinate `value`, clamped to [-1, count] so that far-away shapes cannot overflow.
int clamped_cell(double value, double origin, double resolution, int count) {
  return static_cast<int>(
      std::clamp(std::floor((value - origin) / resolution), -1.0, static_cast<double>(count)));
}

void fill_row(OccupancyGrid& grid, int row, double x_low, double x_high) {
  const int first = std::max(clamped_cell(x_low, grid.origin.x(), grid.resolution, grid.width), 0);
  const int last =
      std::min(clamped_cell(x_high, grid.origin.x(), grid.resolution, grid.width), grid.width - 1);
  for (int column = first; column <= last; ++column)
    grid.cells[grid.index(column, row)] = OccupancyGrid::kOccupied;
}

}  // namespace

void draw_segment(OccupancyGrid& grid, const Segment& segment) {
  if (!segment.a.allFinite() || !segment.b.allFinite()) return;
  const bool upward = segment.a.y() <= segment.b.y();
  const Vector2 low = upward ? segment.a : segment.b;
  const Vector2 high = upward ? segment.b : segment.a;
  const int first = std::max(clamped_cell(low.y(), grid.origin.y(), grid.resolution, grid.height), 0);
  const int last =
      std::min(clamped_cell(high.y(), grid.origin.y(), grid.resolution, grid.height), grid.height - 1);
  const double rise = high.y() - low.y();
  for (int row = first; row <= last; ++row) {
    // The part of the segment inside this row of cells spans one interval of x.
    const double bottom = std::max(low.y(), grid.origin.y() + row * grid.resolution);
    const double top = std::min(high.y(), grid.origin.y() + (row + 1) * grid.resolution);
    const auto x_at = [&](double y) {
      return low.x() + std::clamp((y - low.y()) / rise, 0.0, 1.0) * (high.x() - low.x());
    };
    const double x_bottom = rise > 0.0 ? x_at(bottom) : low.x();
    const double x_top = rise > 0.0 ? x_at(top) : high.x();
    fill_row(grid, row, std::min(x_bottom, x_top), std::max(x_bottom, x_top));
  }
}

void draw_box(OccupancyGrid& grid, const Vector2& corner, const Vector2& opposite) {
  if (!corner.allFinite() || !opposite.allFinite()) return;
  const Vector2 low = corner.cwiseMin(opposite);
  const Vector2 high = corner.cwiseMax(opposite);
  const int first = std::max(clamped_cell(low.y(), grid.origin.y(), grid.resolution, grid.height), 0);
  const int last =
      std::min(clamped_cell(high.y(), grid.origin.y(), grid.resolution, grid.height), grid.height - 1);
  for (int row = first; row <= last; ++row) fill_row(grid, row, low.x(), high.x());
}

}  // namespace bw
