#include "components/mapping/obstacle_extraction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace bw {
namespace {

struct Cell {
  int column = 0;
  int row = 0;
  bool operator==(const Cell&) const = default;
};

Vector2 to_vector(const Cell& c) { return {c.column, c.row}; }

double distance_to_segment(const Vector2& p, const Vector2& a, const Vector2& b) {
  const Vector2 ab = b - a;
  const double squared = ab.squaredNorm();
  const double t = squared > 0.0 ? std::clamp((p - a).dot(ab) / squared, 0.0, 1.0) : 0.0;
  return (p - a - t * ab).norm();
}

// The boundary cells near the robot, as a window of marks with a free rim, so that walking needs no range
// checks.
class Window {
 public:
  Window(const OccupancyGrid& grid, const Vector2& position, const ExtractionOptions& options) {
    const double reach = options.radius + grid.resolution;
    const auto clamped = [](double cell, int count) {
      return static_cast<int>(std::clamp(std::floor(cell), 0.0, static_cast<double>(count)));
    };
    const Vector2 p = (position - grid.origin) / grid.resolution;
    column0_ = clamped(p.x() - reach / grid.resolution, grid.width);
    row0_ = clamped(p.y() - reach / grid.resolution, grid.height);
    width_ = clamped(p.x() + reach / grid.resolution + 1.0, grid.width) - column0_;
    height_ = clamped(p.y() + reach / grid.resolution + 1.0, grid.height) - row0_;
    stride_ = width_ + 2;
    marks_.assign(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(height_ + 2), false);
    const ObstacleRule rule{.occupied_at = options.occupied_at};
    const double squared_radius = std::pow(options.radius / grid.resolution, 2);
    const auto is_free = [&](int column, int row) {
      return grid.contains(column, row) && !rule.blocks(grid.at(column, row));
    };
    for (int row = row0_; row < row0_ + height_; ++row) {
      for (int column = column0_; column < column0_ + width_; ++column) {
        if (!rule.blocks(grid.at(column, row))) continue;
        const double dx = column + 0.5 - p.x();
        const double dy = row + 0.5 - p.y();
        if (dx * dx + dy * dy > squared_radius) continue;
        if (is_free(column - 1, row) || is_free(column + 1, row) || is_free(column, row - 1) ||
            is_free(column, row + 1)) {
          const Cell cell{column, row};
          marks_[index(cell)] = true;
          cells_.push_back(cell);
        }
      }
    }
  }

  const std::vector<Cell>& cells() const { return cells_; }
  bool take(const Cell& cell) { return std::exchange(marks_[index(cell)], static_cast<char>(false)) != 0; }

 private:
  std::size_t index(const Cell& c) const {
    return static_cast<std::size_t>(c.row - row0_ + 1) * static_cast<std::size_t>(stride_) +
           static_cast<std::size_t>(c.column - column0_ + 1);
  }

  int column0_ = 0, row0_ = 0, width_ = 0, height_ = 0, stride_ = 0;
  std::vector<char> marks_;
  std::vector<Cell> cells_;
};

constexpr std::array<Cell, 8> kNeighbours{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

// Appends untaken neighbours one after the other, turning as little as possible, until there is none.
void walk(Window& window, std::vector<Cell>& chain, int heading) {
  constexpr std::array<int, 8> kTurns{0, 1, -1, 2, -2, 3, -3, 4};
  for (bool moved = true; moved;) {
    moved = false;
    for (const int turn : kTurns) {
      const int next_heading = (heading + turn + 8) % 8;
      const Cell& step = kNeighbours[static_cast<std::size_t>(next_heading)];
      const Cell next{chain.back().column + step.column, chain.back().row + step.row};
      if (!window.take(next)) continue;
      chain.push_back(next);
      heading = next_heading;
      moved = true;
      break;
    }
  }
}

std::vector<Cell> trace_chain(Window& window, const Cell& seed) {
  std::vector<Cell> chain{seed};
  walk(window, chain, 0);
  std::reverse(chain.begin(), chain.end());
  walk(window, chain, 4);
  const Cell& a = chain.front();
  const Cell& b = chain.back();
  if (chain.size() > 2 && std::abs(a.column - b.column) <= 1 && std::abs(a.row - b.row) <= 1)
    chain.push_back(a);
  return chain;
}

// Indices of the corners of a polyline that stays within `tolerance` [cells] of all cells of the chain.
std::vector<std::size_t> corners_of(const std::vector<Cell>& chain, double tolerance) {
  std::vector<std::size_t> corners{0};
  std::vector<std::size_t> ends{chain.size() - 1};
  while (!ends.empty()) {
    const std::size_t first = corners.back();
    const std::size_t last = ends.back();
    std::size_t farthest = first;
    double worst = tolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double d =
          distance_to_segment(to_vector(chain[i]), to_vector(chain[first]), to_vector(chain[last]));
      if (d > worst) {
        worst = d;
        farthest = i;
      }
    }
    if (farthest != first) {
      ends.push_back(farthest);
    } else {
      corners.push_back(last);
      ends.pop_back();
    }
  }
  return corners;
}

struct Shape {
  double distance = 0.0;
  Segment segment;
};

}  // namespace

ExtractionResult extract_obstacles(const OccupancyGrid& grid, const Vector2& position,
                                   const ExtractionOptions& options) {
  ExtractionResult result;
  if (!position.allFinite() || grid.cells.empty()) return result;
  Window window(grid, position, options);
  result.boundary_cells = window.cells().size();
  std::vector<Shape> shapes;
  const auto add = [&](const Cell& from, const Cell& to) {
    const Vector2 a = grid.center(from.column, from.row);
    const Vector2 b = grid.center(to.column, to.row);
    shapes.push_back({distance_to_segment(position, a, b), {a, b}});
  };
  for (const Cell& seed : window.cells()) {
    if (!window.take(seed)) continue;
    const std::vector<Cell> chain = trace_chain(window, seed);
    const std::vector<std::size_t> corners = corners_of(chain, options.tolerance_cells);
    if (chain.size() == 1) add(seed, seed);
    for (std::size_t i = 1; chain.size() > 1 && i < corners.size(); ++i)
      add(chain[corners[i - 1]], chain[corners[i]]);
  }
  std::stable_sort(shapes.begin(), shapes.end(),
                   [](const Shape& a, const Shape& b) { return a.distance < b.distance; });
  const std::size_t kept = std::min(shapes.size(), static_cast<std::size_t>(options.max_obstacles));
  result.dropped = shapes.size() - kept;
  for (std::size_t i = 0; i < kept; ++i) {
    const Segment& s = shapes[i].segment;
    if (s.a == s.b) {
      result.obstacles.points.push_back(s.a);
    } else {
      result.obstacles.segments.push_back(s);
    }
  }
  return result;
}

}  // namespace bw
