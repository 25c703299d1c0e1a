#include "components/mapping/keepout_zones.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "components/model/obstacle_rule.hpp"

namespace bw {
namespace {

/// Calls visit(cell, its centre in A) for the cells of `grid`, in B, around which `other`, in A, may be.
template <class Visit>
void for_cells_over(const OccupancyGrid& grid, const OccupancyGrid& other, const Pose2& X_AB, Visit visit) {
  const Pose2 X_BA = inverse(X_AB);
  Vector2 low = Vector2::Constant(std::numeric_limits<double>::infinity());
  Vector2 high = -low;
  for (const int column : {0, other.width}) {
    for (const int row : {0, other.height}) {
      const Vector2 corner = X_BA * Vector2(other.origin + Vector2(column, row) * other.resolution);
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
  }
  const auto cells = [](double length, double resolution, int count) {
    return static_cast<int>(std::clamp(std::floor(length / resolution), 0.0, static_cast<double>(count)));
  };
  const Vector2 from = low - grid.origin;
  const Vector2 to = high - grid.origin + Vector2::Constant(grid.resolution);
  const int columns = cells(to.x(), grid.resolution, grid.width);
  const int rows = cells(to.y(), grid.resolution, grid.height);
  for (int row = cells(from.y(), grid.resolution, grid.height); row < rows; ++row) {
    for (int column = cells(from.x(), grid.resolution, grid.width); column < columns; ++column)
      visit(grid.index(column, row), X_AB * grid.center(column, row));
  }
}

bool is_occupied_at(const OccupancyGrid& grid, const Vector2& point) {
  const Vector2 p = (point - grid.origin) / grid.resolution;
  return p.x() >= 0.0 && p.y() >= 0.0 && p.x() < grid.width && p.y() < grid.height &&
         grid.at(static_cast<int>(p.x()), static_cast<int>(p.y())) == OccupancyGrid::kOccupied;
}

}  // namespace

std::string KeepoutZones::set_mask(const OccupancyGrid& mask) {
  const auto is_none = [](std::int8_t cell) { return cell < -1 || cell > 100; };
  if (const auto bad = std::ranges::find_if(mask.cells, is_none); bad != mask.cells.end())
    return "a cell of it is " + std::to_string(*bad) + ", which is neither -1 nor from 0 to 100";
  cells_ = {.resolution = mask.resolution,
            .origin = mask.origin - Vector2::Constant(mask.resolution),
            .width = mask.width + 2,
            .height = mask.height + 2};
  cells_.cells.assign(static_cast<std::size_t>(cells_.width) * static_cast<std::size_t>(cells_.height),
                      OccupancyGrid::kFree);
  has_zones_ = false;
  for (int row = 0; row < mask.height; ++row) {
    for (int column = 0; column < mask.width; ++column) {
      if (!ObstacleRule{}.blocks(mask.at(column, row))) continue;
      cells_.cells[cells_.index(column + 1, row + 1)] = OccupancyGrid::kOccupied;
      has_zones_ = true;
    }
  }
  return {};
}

bool KeepoutZones::hold(const Vector2& point) const { return has_zones_ && is_occupied_at(cells_, point); }

void KeepoutZones::mark(OccupancyGrid& grid, const Pose2& X_KF) const {
  if (!has_zones_) return;
  for_cells_over(grid, cells_, X_KF, [&](std::size_t cell, const Vector2& center) {
    if (is_occupied_at(cells_, center)) grid.cells[cell] = OccupancyGrid::kOccupied;
  });
  for_cells_over(cells_, grid, inverse(X_KF), [&](std::size_t cell, const Vector2& center) {
    if (cells_.cells[cell] != OccupancyGrid::kOccupied) return;
    const int column = grid.column_of(center.x());
    const int row = grid.row_of(center.y());
    if (grid.contains(column, row)) grid.cells[grid.index(column, row)] = OccupancyGrid::kOccupied;
  });
}

void KeepoutZones::add_to(StaticObstacles& obstacles, const Vector2& position, const Pose2& X_KF,
                          const ExtractionOptions& options) const {
  if (!has_zones_) return;
  const Vector2 here = X_KF * position;
  const Pose2 X_FK = inverse(X_KF);
  const StaticObstacles near = extract_obstacles(cells_, here, options).obstacles;
  if (hold(here)) obstacles.points.push_back(position);
  for (const Vector2& point : near.points) obstacles.points.push_back(X_FK * point);
  for (const Disc& disc : near.discs) obstacles.discs.push_back({X_FK * disc.center, disc.radius});
  for (const Segment& s : near.segments) obstacles.segments.push_back({X_FK * s.a, X_FK * s.b});
}

}  // namespace bw
