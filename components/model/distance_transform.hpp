// Exact Euclidean distance to the nearest obstacle for every cell of a grid, in time linear in the cells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "components/model/obstacle_rule.hpp"
#include "components/model/occupancy_grid.hpp"

namespace bw {

/// For each cell (row-major, as in `grid`): distance [m] from its centre to the nearest centre of an obstacle
/// cell; 0 in an obstacle, infinity when the grid has none. What lies outside the grid counts as free.
/// Separable lower envelope of parabolas in integers (Meijster, Roerdink and Hesselink 2000; Felzenszwalb and
/// Huttenlocher 2012), so equal to brute force.
std::vector<float> distance_field(const OccupancyGrid& grid, const ObstacleRule& rule);

/// The same as whole squared distances, for grids that come again and again: keeps its memory.
class DistanceTransform {
 public:
  static constexpr std::int32_t kNone = std::numeric_limits<std::int32_t>::max();

  /// Squared distance [cells^2] of each cell; kNone without obstacles, and beyond `reach` [cells, at most
  /// 46340]. A short reach is looked through in vectors, which is ten times as fast. Valid until the next call.
  const std::vector<std::int32_t>& squared_cells(const OccupancyGrid& grid, const ObstacleRule& rule,
                                                 int reach);

 private:
  std::vector<std::int32_t> in_column_;
  std::vector<std::int64_t> column_;
  std::vector<std::int64_t> from_;
  std::vector<std::int16_t> near_, nearest_;  ///< of one row
  std::vector<std::int32_t> squared_;
};

}  // namespace bw
