// Everything in the world that never moves: walls as segments, pillars as discs, and a map's occupied cells.
// Frame: map.
#pragma once

#include <optional>
#include <vector>

#include "components/model/obstacles.hpp"
#include "components/world/grid_scene.hpp"

namespace bw {

class StaticScene {
 public:
  /// `shapes.points` are not part of the world (a point has no size); segments and discs are.
  StaticScene(StaticObstacles shapes, const std::optional<OccupancyGrid>& map);

  const std::vector<Segment>& segments() const { return shapes_.segments; }
  const std::vector<Disc>& discs() const { return shapes_.discs; }
  const std::optional<GridScene>& grid() const { return grid_; }

  /// The nearest static point within `limit` [m] of `point`.
  std::optional<Vector2> nearest_point(const Vector2& point, double limit) const;

  /// Distance [m] from `point` to the nearest static thing, at most `limit`; 0 inside a disc or a solid cell.
  double clearance(const Vector2& point, double limit) const;

 private:
  StaticObstacles shapes_;
  std::optional<GridScene> grid_;
};

}  // namespace bw
