#include "components/world/grid_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "components/world/ray.hpp"

namespace bw {
namespace {

constexpr int kFar = 65535;

/// Two raster passes over the eight neighbours: exact for the Chebyshev metric.
std::vector<std::uint16_t> chebyshev_field(const OccupancyGrid& grid) {
  std::vector<std::uint16_t> field(grid.cells.size());
  const auto relax = [&](int column, int row, int step) {
    const std::size_t here = grid.index(column, row);
    int best = field[here];
    const std::array<std::array<int, 2>, 4> before = {
        {{column - step, row}, {column - 1, row - step}, {column, row - step}, {column + 1, row - step}}};
    for (const auto& [c, r] : before) {
      if (grid.contains(c, r)) best = std::min(best, field[grid.index(c, r)] + 1);
    }
    field[here] = static_cast<std::uint16_t>(best);
  };
  for (std::size_t i = 0; i < field.size(); ++i) field[i] = grid.cells[i] >= GridScene::kSolidFrom ? 0 : kFar;
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) relax(column, row, 1);
  }
  for (int row = grid.height - 1; row >= 0; --row) {
    for (int column = grid.width - 1; column >= 0; --column) relax(column, row, -1);
  }
  return field;
}

/// One axis of the walk, in cells from the grid's corner: border to be crossed next, and when.
struct Axis {
  double start;
  double direction;
  int cells;
  int cell = 0;

  int border(int stride) const { return direction > 0.0 ? cell + stride : cell - stride + 1; }
  double time_to_border(int stride) const {
    return direction == 0.0 ? kNoHit : (border(stride) - start) / direction;
  }
  void cross_border(int stride) { cell = direction > 0.0 ? cell + stride : cell - stride; }
  /// The cell at `t`, kept inside the stride and never backwards, whatever rounding says.
  void drift(double t, int stride) {
    const int low = direction > 0.0 ? cell : std::max(0, cell - stride + 1);
    const int high = direction < 0.0 ? cell : std::min(cells - 1, cell + stride - 1);
    cell = std::clamp(static_cast<int>(std::floor(start + t * direction)), low, high);
  }
  bool inside() const { return cell >= 0 && cell < cells; }
};

/// Narrows [enter, leave] to the time the ray spends between the grid's borders on this axis.
void clip(const Axis& axis, double& enter, double& leave) {
  if (axis.direction == 0.0) {
    if (axis.start < 0.0 || axis.start >= axis.cells) leave = -kNoHit;
    return;
  }
  const double t0 = -axis.start / axis.direction;
  const double t1 = (axis.cells - axis.start) / axis.direction;
  enter = std::max(enter, std::min(t0, t1));
  leave = std::min(leave, std::max(t0, t1));
}

}  // namespace

GridScene::GridScene(const OccupancyGrid& grid)
    : resolution_(grid.resolution), origin_(grid.origin), width_(grid.width), height_(grid.height) {
  if (!(grid.resolution > 0.0) || !std::isfinite(grid.resolution) || grid.width <= 0 || grid.height <= 0 ||
      grid.cells.size() / static_cast<std::size_t>(grid.width) != static_cast<std::size_t>(grid.height) ||
      grid.cells.size() % static_cast<std::size_t>(grid.width) != 0) {
    throw std::runtime_error("world map: " + std::to_string(grid.width) + " x " +
                             std::to_string(grid.height) + " cells of " + std::to_string(grid.resolution) +
                             " m do not fit its " + std::to_string(grid.cells.size()) + " values");
  }
  cells_to_solid_ = chebyshev_field(grid);
}

double GridScene::ray_hit(const Vector2& origin, const Vector2& unit_direction, double max_range) const {
  Axis x{(origin.x() - origin_.x()) / resolution_, unit_direction.x(), width_};
  Axis y{(origin.y() - origin_.y()) / resolution_, unit_direction.y(), height_};
  double t = 0.0;
  double leave = max_range / resolution_;
  clip(x, t, leave);
  clip(y, t, leave);
  if (t > leave) return kNoHit;
  x.cell = std::clamp(static_cast<int>(std::floor(x.start + t * x.direction)), 0, x.cells - 1);
  y.cell = std::clamp(static_cast<int>(std::floor(y.start + t * y.direction)), 0, y.cells - 1);
  while (t <= leave && x.inside() && y.inside()) {
    const int stride = strides(x.cell, y.cell);
    if (stride == 0) return t * resolution_;
    const double tx = x.time_to_border(stride);
    const double ty = y.time_to_border(stride);
    if (tx < ty) {
      t = tx;
      x.cross_border(stride);
      y.drift(t, stride);
    } else {
      t = ty;
      y.cross_border(stride);
      x.drift(t, stride);
    }
  }
  return kNoHit;
}

std::vector<Segment> GridScene::edges_within(const Vector2& point, double reach) const {
  std::vector<Segment> edges;
  const auto solid = [&](int column, int row) {
    return column >= 0 && column < width_ && row >= 0 && row < height_ && strides(column, row) == 0;
  };
  const auto first = [&](double value, double low) {
    return static_cast<int>(std::max(0.0, std::floor((value - reach - low) / resolution_)));
  };
  const auto end = [&](double value, double low, int cells) {
    return static_cast<int>(
        std::clamp(std::ceil((value + reach - low) / resolution_), 0.0, static_cast<double>(cells)));
  };
  const int last_row = end(point.y(), origin_.y(), height_),
            last_column = end(point.x(), origin_.x(), width_);
  for (int row = first(point.y(), origin_.y()); row < last_row; ++row) {
    for (int column = first(point.x(), origin_.x()); column < last_column;) {
      const int free = strides(column, row);
      const int here = std::exchange(column, column + std::max(1, free));
      if (free > 0) continue;
      const Vector2 low = origin_ + resolution_ * Vector2(here, row);
      const Vector2 high = origin_ + resolution_ * Vector2(here + 1, row + 1);
      if ((point.cwiseMax(low).cwiseMin(high) - point).norm() > reach) continue;
      if (!solid(here - 1, row)) edges.push_back({low, {low.x(), high.y()}});
      if (!solid(here + 1, row)) edges.push_back({{high.x(), low.y()}, high});
      if (!solid(here, row - 1)) edges.push_back({low, {high.x(), low.y()}});
      if (!solid(here, row + 1)) edges.push_back({{low.x(), high.y()}, high});
    }
  }
  return edges;
}

std::optional<Vector2> GridScene::nearest_point(const Vector2& point, double limit) const {
  // From outside, the search starts at the nearest cell of the grid: no solid cell is nearer to the point
  // than to it.
  const auto cell_of = [&](double value, double low, int cells) {
    return static_cast<int>(std::clamp(std::floor((value - low) / resolution_), 0.0, cells - 1.0));
  };
  const int column = cell_of(point.x(), origin_.x(), width_);
  const int row = cell_of(point.y(), origin_.y(), height_);
  std::optional<Vector2> nearest;
  double best = limit;
  const auto consider = [&](int c, int r) {
    const Vector2 low = origin_ + resolution_ * Vector2(c, r);
    const Vector2 high = origin_ + resolution_ * Vector2(c + 1, r + 1);
    const Vector2 candidate = point.cwiseMax(low).cwiseMin(high);
    const double distance = (candidate - point).norm();
    if (distance > best) return;
    best = distance;
    nearest = candidate;
  };
  // Square rings around the start cell, nearest first; along a side the field tells how many cells can be
  // skipped.
  const int last_ring = std::max({column, row, width_ - 1 - column, height_ - 1 - row});
  for (int ring = strides(column, row); ring <= last_ring && (ring - 1) * resolution_ <= best; ++ring) {
    for (const int r : {row - ring, row + ring}) {
      if (r < 0 || r >= height_) continue;
      for (int c = std::max(0, column - ring); c <= std::min(width_ - 1, column + ring);) {
        const int free = strides(c, r);
        if (free == 0) consider(c, r);
        c += std::max(1, free);
      }
      if (ring == 0) break;
    }
    for (const int c : {column - ring, column + ring}) {
      if (c < 0 || c >= width_ || ring == 0) continue;
      for (int r = std::max(0, row - ring + 1); r <= std::min(height_ - 1, row + ring - 1);) {
        const int free = strides(c, r);
        if (free == 0) consider(c, r);
        r += std::max(1, free);
      }
    }
  }
  return nearest;
}

}  // namespace bw
