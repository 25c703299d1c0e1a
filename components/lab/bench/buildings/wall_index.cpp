#include "components/lab/bench/buildings/wall_index.hpp"

#include <algorithm>
#include <numbers>

#include "components/model/nearest_point.hpp"
#include "components/world/ray.hpp"

namespace bw::buildings {
namespace {

double distance_between(const Segment& wall, const Vector2& point) {
  return (nearest_point(wall, point) - point).norm();
}

/// One axis of the walk from cell to cell, in metres along the ray.
struct CellAxis {
  int step;
  double next;   ///< border that is crossed next
  double apart;  ///< from border to border

  CellAxis(double from_low, double direction, double cell, int index)
      : step(direction < 0.0 ? -1 : 1),
        next(direction == 0.0 ? kNoHit : ((index + (direction < 0.0 ? 0 : 1)) * cell - from_low) / direction),
        apart(direction == 0.0 ? kNoHit : cell / std::abs(direction)) {}
};

}  // namespace

WallIndex::WallIndex(const std::vector<Segment>& walls) : first_{0} {
  if (walls.empty()) return;
  Vector2 high = low_ = walls.front().a;
  for (const Segment& wall : walls) {
    low_ = low_.cwiseMin(wall.a).cwiseMin(wall.b);
    high = high.cwiseMax(wall.a).cwiseMax(wall.b);
  }
  columns_ = column_of(high.x()) + 1;
  rows_ = row_of(high.y()) + 1;
  // Every wall that comes into a cell, and some that pass its corners: a little more than half the diagonal.
  constexpr double kNear = kCell * std::numbers::sqrt2 / 2.0 + 1e-6;
  std::vector<std::vector<Segment>> cells(index(0, rows_));
  for (const Segment& wall : walls) {
    const int first_column = std::max(0, column_of(std::min(wall.a.x(), wall.b.x())) - 1);
    const int last_column = std::min(columns_ - 1, column_of(std::max(wall.a.x(), wall.b.x())) + 1);
    const int first_row = std::max(0, row_of(std::min(wall.a.y(), wall.b.y())) - 1);
    const int last_row = std::min(rows_ - 1, row_of(std::max(wall.a.y(), wall.b.y())) + 1);
    for (int row = first_row; row <= last_row; ++row) {
      for (int column = first_column; column <= last_column; ++column) {
        const Vector2 center = low_ + kCell * Vector2(column + 0.5, row + 0.5);
        if (distance_between(wall, center) <= kNear) cells[index(column, row)].push_back(wall);
      }
    }
  }
  for (const auto& cell : cells) {
    walls_.insert(walls_.end(), cell.begin(), cell.end());
    first_.push_back(static_cast<std::uint32_t>(walls_.size()));
  }
}

double WallIndex::ray_hit(const Vector2& origin, const Vector2& unit_direction, double limit) const {
  double nearest = kNoHit;
  int column = column_of(origin.x());
  int row = row_of(origin.y());
  CellAxis x(origin.x() - low_.x(), unit_direction.x(), kCell, column);
  CellAxis y(origin.y() - low_.y(), unit_direction.y(), kCell, row);
  while (contains(column, row)) {
    const std::size_t cell = index(column, row);
    for (std::size_t i = first_[cell]; i < first_[cell + 1]; ++i)
      nearest = std::min(nearest, bw::ray_hit(origin, unit_direction, walls_[i]));
    CellAxis& crossed = x.next < y.next ? x : y;
    if (nearest <= crossed.next || crossed.next >= limit) break;
    (x.next < y.next ? column : row) += crossed.step;
    crossed.next += crossed.apart;
  }
  return nearest < limit ? nearest : kNoHit;
}

double WallIndex::clearance(const Vector2& point, double limit) const {
  double nearest = limit;
  const int last_row = std::min(rows_ - 1, row_of(point.y() + limit));
  const int last_column = std::min(columns_ - 1, column_of(point.x() + limit));
  for (int row = std::max(0, row_of(point.y() - limit)); row <= last_row; ++row) {
    for (int column = std::max(0, column_of(point.x() - limit)); column <= last_column; ++column) {
      const std::size_t cell = index(column, row);
      for (std::size_t i = first_[cell]; i < first_[cell + 1]; ++i)
        nearest = std::min(nearest, distance_between(walls_[i], point));
    }
  }
  return nearest;
}

}  // namespace bw::buildings
