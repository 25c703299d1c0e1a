// Costs around obstacles by Nav2's formula, from exact distances, and how a costmap looks as an
// OccupancyGrid.
//
//   254                                                       in an obstacle cell
//   253                                                       for d <= inscribed
//   trunc(252 exp(-cost_scaling_factor (d - inscribed)))      up to inflation_radius
//   0                                                         beyond
//   255                                                       unknown
//
// with d the distance between cell centres [m].
#pragma once

#include <cstdint>
#include <vector>

#include "components/mapping/costmap/costmap_options.hpp"
#include "components/model/cell_cost.hpp"
#include "components/model/distance_transform.hpp"
#include "components/model/occupancy_grid.hpp"

namespace bw::costmap {

/// Cost of a known cell at `distance` [m] from the nearest obstacle cell.
std::uint8_t cost_at(double distance, double inscribed_radius, const InflationOptions& options);

/// Cost as an occupancy value, as Nav2 publishes it: 0, -1, 100, 99 for free, unknown, lethal, inscribed, and
/// 1 to 98 for the rest.
std::int8_t occupancy_of(std::uint8_t cost);

/// Keeps its memory and its table of costs from grid to grid.
class Inflation {
 public:
  Inflation(const InflationOptions& options, double inscribed_radius, double resolution);

  /// Costs of `grid` (row-major; its resolution as constructed). An unknown cell keeps 255, unless an
  /// obstacle lies within the inscribed radius of it, or inflate_unknown is set. Valid until the next call.
  const std::vector<std::uint8_t>& costs(const OccupancyGrid& grid);

 private:
  InflationOptions options_;
  int reach_;  ///< of the inflation [cells]
  DistanceTransform transform_;
  std::vector<std::uint8_t> table_;  ///< cost by squared distance [cells^2]
  std::vector<std::uint8_t> costs_;
};

}  // namespace bw::costmap
