#include "components/mapping/obstacle_extraction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace bw {
namespace {

struct Cell {
  int column = 0;
  int row = 0;
  bool operator==(const Cell&) const = default;
};

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
      if (!grid.contains(column, row)) return false;
      const std::int8_t value = grid.at(column, row);
      return value < 0 ? options.face_unknown : !rule.blocks(value);
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

// Appends untaken neighbours one after the other, changing heading as little as possible, until there is
// none.
void walk(Window& window, std::vector<Cell>& chain, int heading) {
  constexpr std::array<int, 8> kHeadingChanges{0, 1, -1, 2, -2, 3, -3, 4};
  for (bool moved = true; moved;) {
    moved = false;
    for (const int change : kHeadingChanges) {
      const int next_heading = (heading + change + 8) % 8;
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

bool stays_within(const std::vector<Vector2>& chain, std::size_t first, std::size_t last, double tolerance) {
  const Vector2& a = chain[first];
  const Vector2& b = chain[last];
  for (std::size_t i = first + 1; i < last; ++i) {
    if (distance_to_segment(chain[i], a, b) > tolerance) return false;
  }
  return true;
}

// Indices of the corners of a polyline that stays within `tolerance` [cells] of the whole chain. Each
// segment reaches as far as doubling and then halving strides find.
std::vector<std::size_t> corners_of(const std::vector<Vector2>& chain, double tolerance) {
  std::vector<std::size_t> corners{0};
  while (corners.back() + 1 < chain.size()) {
    const std::size_t first = corners.back();
    std::size_t last = first + 1;
    std::size_t stride = 1;
    while (last + stride < chain.size() && stays_within(chain, first, last + stride, tolerance)) {
      last += stride;
      stride *= 2;
    }
    for (; stride > 0; stride /= 2) {
      if (last + stride < chain.size() && stays_within(chain, first, last + stride, tolerance))
        last += stride;
    }
    corners.push_back(last);
  }
  return corners;
}

// A disc [cells] whose rim passes within `tolerance` of all points of a closed chain, if there is one of at
// most `max_radius`: pillars, legs and specks. Nothing that fits inside so small a ring could be missed.
std::optional<Disc> round_outline(const std::vector<Vector2>& chain, double tolerance, double max_radius) {
  if (chain.size() < 4 || chain.front() != chain.back()) return std::nullopt;
  Vector2 center = Vector2::Zero();
  for (std::size_t i = 1; i < chain.size(); ++i) center += chain[i] / static_cast<double>(chain.size() - 1);
  double smallest = std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (const Vector2& point : chain) {
    const double distance = (point - center).norm();
    smallest = std::min(smallest, distance);
    largest = std::max(largest, distance);
  }
  if (largest - smallest > 2.0 * tolerance || largest > max_radius) return std::nullopt;
  return Disc{center, (smallest + largest) / 2.0};
}

// Nearest first; a point is a segment without length.
struct Shape {
  double distance = 0.0;
  std::variant<Segment, Disc> form;
};

// Where the surface runs through the cells of a chain [cells].
std::vector<Vector2> points_of(const OccupancyGrid& grid, const std::vector<Cell>& chain,
                               std::span<const Eigen::Vector2f> surface) {
  std::vector<Vector2> points;
  points.reserve(chain.size());
  for (const Cell& cell : chain) {
    points.emplace_back(cell.column + 0.5, cell.row + 0.5);
    if (!surface.empty()) points.back() += surface[grid.index(cell.column, cell.row)].cast<double>();
  }
  return points;
}

// Shapes of one chain, from cells to metres.
void add_shapes(const OccupancyGrid& grid, const Vector2& position, const std::vector<Vector2>& chain,
                double tolerance, std::vector<Shape>& shapes) {
  constexpr double kMaxDiscRadius = 0.5;  // [m]
  const auto to_metres = [&](const Vector2& p) { return Vector2(grid.origin + p * grid.resolution); };
  if (auto disc = round_outline(chain, tolerance, kMaxDiscRadius / grid.resolution)) {
    disc->center = to_metres(disc->center);
    disc->radius *= grid.resolution;
    const double distance = (disc->center - position).norm() - disc->radius;
    if (distance > 0.0) {
      shapes.push_back({distance, *disc});
      return;
    }
  }
  const auto add = [&](const Vector2& from, const Vector2& to) {
    const Segment segment{to_metres(from), to_metres(to)};
    shapes.push_back({distance_to_segment(position, segment.a, segment.b), segment});
  };
  if (chain.size() == 1) add(chain[0], chain[0]);
  const std::vector<std::size_t> corners = corners_of(chain, tolerance);
  for (std::size_t i = 1; i < corners.size(); ++i) add(chain[corners[i - 1]], chain[corners[i]]);
}

}  // namespace

ExtractionResult extract_obstacles(const OccupancyGrid& grid, const Vector2& position,
                                   const ExtractionOptions& options,
                                   std::span<const Eigen::Vector2f> surface) {
  ExtractionResult result;
  if (!position.allFinite() || grid.cells.empty()) return result;
  Window window(grid, position, options);
  result.boundary_cells = window.cells().size();
  std::vector<Shape> shapes;
  for (const Cell& seed : window.cells()) {
    if (window.take(seed)) {
      add_shapes(grid, position, points_of(grid, trace_chain(window, seed), surface), options.tolerance_cells,
                 shapes);
    }
  }
  std::stable_sort(shapes.begin(), shapes.end(),
                   [](const Shape& a, const Shape& b) { return a.distance < b.distance; });
  for (const Shape& shape : shapes) {
    if (const Disc* disc = std::get_if<Disc>(&shape.form)) {
      result.obstacles.discs.push_back(*disc);
      continue;
    }
    const Segment& segment = std::get<Segment>(shape.form);
    if (segment.a == segment.b) {
      result.obstacles.points.push_back(segment.a);
    } else {
      result.obstacles.segments.push_back(segment);
    }
  }
  return result;
}

}  // namespace bw
