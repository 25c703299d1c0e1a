#include "components/global_planner/path_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bw {
namespace {

// Walks the cells under a line (Amanatides and Woo 1987) along one axis.
struct Axis {
  int cell = 0;
  int step = 0;
  double next = std::numeric_limits<double>::infinity();   // line parameter at the next border of cells
  double delta = std::numeric_limits<double>::infinity();  // between borders

  Axis(double from, double to) : cell(static_cast<int>(std::floor(from))) {
    const double d = to - from;
    if (d == 0.0) return;
    step = d > 0.0 ? 1 : -1;
    delta = 1.0 / std::abs(d);
    next = (d > 0.0 ? cell + 1 - from : from - cell) * delta;
  }

  void advance() {
    cell += step;
    next += delta;
  }
};

// In narrow cells the footprint must fit all along the line.
bool passes(const SearchGrid& grid, const Vector2& a, const Vector2& b, double from, double to,
            double heading) {
  constexpr double kStep = 0.02;  // [m]
  const double length = (b - a).norm() * (to - from);
  const int pieces = std::max(1, static_cast<int>(std::ceil(length / kStep)));
  for (int i = 0; i <= pieces; ++i) {
    const Vector2 p = a + (from + (to - from) * i / pieces) * (b - a);
    if (!grid.fits({p.x(), p.y(), heading})) return false;
  }
  return true;
}

}  // namespace

LineOfSight line_of_sight(const SearchGrid& grid, const Vector2& from, const Vector2& to) {
  constexpr double kCorner = 1e-9;  // crossings closer than this meet at a corner of cells
  const Vector2 a = grid.to_cells(from);
  const Vector2 b = grid.to_cells(to);
  const double length = (to - from).norm();
  const double heading = std::atan2(to.y() - from.y(), to.x() - from.x());
  Axis x(a.x(), b.x());
  Axis y(a.y(), b.y());
  LineOfSight result{.clearance = std::numeric_limits<float>::infinity()};
  for (double t = 0.0;;) {
    if (!grid.free(x.cell, y.cell)) return result;
    const double next = std::min({x.next, y.next, 1.0});
    const NarrowCell* narrow = grid.narrow(x.cell, y.cell);
    if (narrow != nullptr && !passes(grid, from, to, t, std::max(t, next), heading)) return result;
    const double share = std::max(next - t, 0.0) * length;
    result.cost += share * grid.cells()[grid.index(x.cell, y.cell)].cost / kUnit;
    result.clearance = std::min(result.clearance, grid.clearance(x.cell, y.cell));
    if (next >= 1.0) break;
    t = next;
    if (std::abs(x.next - y.next) < kCorner) {
      if (narrow == nullptr && (!grid.free(x.cell + x.step, y.cell) || !grid.free(x.cell, y.cell + y.step))) {
        return result;
      }
      x.advance();
      y.advance();
    } else if (x.next < y.next) {
      x.advance();
    } else {
      y.advance();
    }
  }
  result.free = true;
  return result;
}

std::vector<Vector2> shorten(const SearchGrid& grid, const GridPath& path, const Vector2& start,
                             const Vector2& goal) {
  const std::size_t last = path.cells.size() - 1;
  const auto point = [&](std::size_t i) -> Vector2 {
    if (i == 0) return start;
    return i == last ? goal : grid.position(path.cells[i].x, path.cells[i].y);
  };
  const auto may_skip = [&](std::size_t from, std::size_t to) {
    const LineOfSight line = line_of_sight(grid, point(from), point(to));
    if (!line.free) return false;
    const double cost = grid.resolution() * (path.cost_so_far[to] - path.cost_so_far[from]) / kUnit;
    // The ends lie anywhere in their cells, and a step is charged where it ends: one cell of leeway.
    if (line.cost > cost + grid.resolution()) return false;
    float clearance = std::numeric_limits<float>::infinity();
    for (std::size_t i = from; i <= to; ++i) {
      clearance = std::min(clearance, grid.clearance(path.cells[i].x, path.cells[i].y));
    }
    return line.clearance >= clearance - static_cast<float>(grid.resolution());
  };

  std::vector<Vector2> corners{start};
  for (std::size_t from = 0; from < last;) {
    // Doubling strides while they see, then halving: few lines are drawn even on long paths.
    std::size_t seen = from + 1;
    std::size_t stride = 1;
    while (seen < last && may_skip(from, std::min(seen + stride, last))) {
      seen = std::min(seen + stride, last);
      stride *= 2;
    }
    for (stride /= 2; stride > 0; stride /= 2) {
      if (seen + stride <= last && may_skip(from, seen + stride)) seen += stride;
    }
    corners.push_back(point(seen));
    from = seen;
  }
  return corners;
}

std::vector<Pose2> sample(const std::vector<Vector2>& corners, double spacing, double goal_heading) {
  std::vector<Pose2> path;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Vector2 d = corners[i] - corners[i - 1];
    const double length = d.norm();
    if (length == 0.0) continue;
    const double heading = std::atan2(d.y(), d.x());
    const auto pieces = static_cast<int>(std::max(std::ceil(length / spacing), 1.0));
    for (int k = 0; k < pieces; ++k) {
      const Vector2 p = corners[i - 1] + d * (static_cast<double>(k) / pieces);
      path.push_back({p.x(), p.y(), heading});
    }
  }
  path.push_back({corners.back().x(), corners.back().y(), wrap_angle(goal_heading)});
  return path;
}

}  // namespace bw
