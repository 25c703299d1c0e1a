#include "components/mapping/rasterize.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace bw {
namespace {

// Column or row of coordinate `value`, clamped to [-1, count] so that far-away shapes cannot overflow.
int clamped_cell(double value, double origin, double resolution, int count) {
  return static_cast<int>(
      std::clamp(std::floor((value - origin) / resolution), -1.0, static_cast<double>(count)));
}

// [m] a corner on the line between two rows falls into one by a division, and the line itself comes of a
// product: by as much as they may differ, a row is taken to be higher. Else a wall along such a line would be
// in no row at all.
constexpr double kRounding = 1e-9;

struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

// Adds the x of the part of edge a-b that lies between two heights.
void include_edge(const Vector2& a, const Vector2& b, double bottom, double top, Interval& x) {
  const Vector2& low = a.y() <= b.y() ? a : b;
  const Vector2& high = a.y() <= b.y() ? b : a;
  if (high.y() < bottom || low.y() > top) return;
  const double rise = high.y() - low.y();
  const auto x_at = [&](double y) {
    return low.x() + std::clamp((y - low.y()) / rise, 0.0, 1.0) * (high.x() - low.x());
  };
  x.include(low.y() >= bottom || rise <= 0.0 ? low.x() : x_at(bottom));
  x.include(high.y() <= top || rise <= 0.0 ? high.x() : x_at(top));
}

}  // namespace

void draw_convex(OccupancyGrid& grid, const std::vector<Vector2>& corners, std::int8_t value) {
  Interval y;
  for (const Vector2& corner : corners) {
    if (!corner.allFinite()) return;
    y.include(corner.y());
  }
  if (corners.empty()) return;
  const int first = std::max(clamped_cell(y.low, grid.origin.y(), grid.resolution, grid.height), 0);
  const int last =
      std::min(clamped_cell(y.high, grid.origin.y(), grid.resolution, grid.height), grid.height - 1);
  for (int row = first; row <= last; ++row) {
    // Inside one row of cells a convex shape spans one interval of x, found from its edges.
    const double bottom = grid.origin.y() + row * grid.resolution - kRounding;
    const double top = bottom + grid.resolution + 2.0 * kRounding;
    Interval x;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      include_edge(corners[i], corners[(i + 1) % corners.size()], bottom, top, x);
    }
    const int left = std::max(clamped_cell(x.low, grid.origin.x(), grid.resolution, grid.width), 0);
    const int right =
        std::min(clamped_cell(x.high, grid.origin.x(), grid.resolution, grid.width), grid.width - 1);
    for (int column = left; column <= right; ++column) {
      grid.cells[grid.index(column, row)] = value;
    }
  }
}

void draw_polygon(OccupancyGrid& grid, const std::vector<Vector2>& corners, std::int8_t value) {
  if (!std::ranges::all_of(corners, [](const Vector2& corner) { return corner.allFinite(); })) return;
  for (std::size_t i = 0; i < corners.size(); ++i)
    draw_segment(grid, {corners[i], corners[(i + 1) % corners.size()]}, value);
  // What is left are cells whose middle lies within: along the middle of a row, where more sides that go up
  // were crossed than such that go down, or fewer.
  struct Crossing {
    double x = 0.0;
    int up = 0;
  };
  std::vector<Crossing> crossings;
  for (int row = 0; row < grid.height; ++row) {
    const double y = grid.center(0, row).y();
    crossings.clear();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vector2& a = corners[i];
      const Vector2& b = corners[(i + 1) % corners.size()];
      if ((a.y() <= y) != (b.y() <= y))
        crossings.push_back({a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()), a.y() <= y ? 1 : -1});
    }
    std::ranges::sort(crossings, {}, &Crossing::x);
    int winding = 0;
    for (std::size_t i = 1; i < crossings.size(); ++i) {
      winding += crossings[i - 1].up;
      if (winding == 0) continue;
      const int first = clamped_cell(crossings[i - 1].x + grid.resolution / 2.0, grid.origin.x(),
                                     grid.resolution, grid.width);
      const int last = clamped_cell(crossings[i].x - grid.resolution / 2.0, grid.origin.x(), grid.resolution,
                                    grid.width - 1);
      for (int column = std::max(first, 0); column <= last; ++column)
        grid.cells[grid.index(column, row)] = value;
    }
  }
}

bool grow_to_hold(OccupancyGrid& grid, const std::vector<Vector2>& points, double max_cells) {
  Vector2 low = Vector2::Zero();  // [cells] from the corners of the grid
  Vector2 high(grid.width, grid.height);
  for (const Vector2& point : points) {
    const Vector2 cell = ((point - grid.origin) / grid.resolution).array().floor();
    low = low.cwiseMin(cell);
    high = high.cwiseMax(cell + Vector2::Ones());
  }
  const Vector2 size = high - low;
  if (size.x() * size.y() > max_cells) return false;
  OccupancyGrid larger{.resolution = grid.resolution,
                       .origin = grid.origin + low * grid.resolution,
                       .width = static_cast<int>(size.x()),
                       .height = static_cast<int>(size.y())};
  larger.cells.assign(static_cast<std::size_t>(larger.width) * static_cast<std::size_t>(larger.height),
                      OccupancyGrid::kUnknown);
  for (int row = 0; row < grid.height; ++row) {
    std::copy_n(grid.cells.begin() + static_cast<std::ptrdiff_t>(grid.index(0, row)), grid.width,
                larger.cells.begin() + static_cast<std::ptrdiff_t>(larger.index(
                                           -static_cast<int>(low.x()), row - static_cast<int>(low.y()))));
  }
  grid = std::move(larger);
  return true;
}

void draw_disc(OccupancyGrid& grid, const Disc& disc) {
  constexpr int kEdges = 16;
  const double corner_radius = disc.radius / std::cos(std::numbers::pi / kEdges);
  std::vector<Vector2> corners;
  corners.reserve(kEdges);
  for (int i = 0; i < kEdges; ++i) {
    corners.push_back(disc.center + corner_radius * direction(2.0 * std::numbers::pi * i / kEdges));
  }
  draw_convex(grid, corners);
}

}  // namespace bw
