// Walls by where they are: what a ray meets first, and how near the nearest is, without a look at the others.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "components/model/obstacles.hpp"

namespace bw::buildings {

/// A lattice of square cells over the walls; each cell knows the walls that come into it. Equal to a search
/// through all of them (world/ray.hpp), bit by bit. A ray from outside of the lattice meets nothing.
class WallIndex {
 public:
  explicit WallIndex(const std::vector<Segment>& walls);

  /// Along the ray [m]; kNoHit when nothing is nearer than `limit`.
  double ray_hit(const Vector2& origin, const Vector2& unit_direction, double limit) const;

  /// Distance from `point` to the nearest wall [m], at most `limit`.
  double clearance(const Vector2& point, double limit) const;

 private:
  static constexpr double kCell = 1.0;  ///< [m]

  int column_of(double x) const { return static_cast<int>(std::floor((x - low_.x()) / kCell)); }
  int row_of(double y) const { return static_cast<int>(std::floor((y - low_.y()) / kCell)); }
  bool contains(int column, int row) const {
    return column >= 0 && row >= 0 && column < columns_ && row < rows_;
  }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  Vector2 low_{0.0, 0.0};
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::uint32_t> first_;  ///< of each cell in walls_, and one for the end
  std::vector<Segment> walls_;        ///< cell by cell, side by side in memory
};

}  // namespace bw::buildings
