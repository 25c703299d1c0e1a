// The occupied cells of a map as solid squares: exact rays and exact nearest points.
//
// Rays walk from cell to cell (Amanatides and Woo 1987). A field with every cell's Chebyshev distance to the
// nearest occupied cell lets a ray cross the whole square of free cells around it in one stride; the hit is
// still the exact crossing of the border of the occupied cell. Outside the grid and in unknown cells nothing
// stands.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "components/model/obstacles.hpp"
#include "components/model/occupancy_grid.hpp"

namespace bw {

class GridScene {
 public:
  /// Cells of at least this occupancy are solid: the usual threshold 0.65 of map files.
  static constexpr std::int8_t kSolidFrom = 65;

  /// Throws std::runtime_error when the grid's sizes do not fit its cells or its resolution is not positive.
  explicit GridScene(const OccupancyGrid& grid);

  /// Distance [m] along the ray to the first solid cell, 0 from inside one; kNoHit beyond max_range.
  double ray_hit(const Vector2& origin, const Vector2& unit_direction, double max_range) const;

  /// Nearest point of a solid cell within `limit` [m]; the point itself when it lies in one.
  std::optional<Vector2> nearest_point(const Vector2& point, double limit) const;

  /// The borders of solid cells towards cells that are not solid, of all that come within `reach` [m] of the
  /// point.
  std::vector<Segment> edges_within(const Vector2& point, double reach) const;

 private:
  int strides(int column, int row) const {
    return cells_to_solid_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                           static_cast<std::size_t>(column)];
  }

  double resolution_;
  Vector2 origin_;
  int width_;
  int height_;
  std::vector<std::uint16_t> cells_to_solid_;  ///< Chebyshev distance [cells], 0 in a solid cell
};

}  // namespace bw
