#include "components/global_planner/costs.hpp"

#include <algorithm>
#include <cmath>

#include "components/model/cell_cost.hpp"

namespace bw {

std::vector<std::uint8_t> costs_of(const SearchGrid& grid, const OccupancyGrid& map,
                                   double clearance_weight) {
  const double most = clearance_weight * kUnit;
  std::vector<std::uint8_t> costs;
  costs.reserve(map.cells.size());
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      const std::size_t i = grid.index(column + 1, row + 1);
      const std::uint16_t cost = grid.cells()[i].cost;
      if (cost != 0) {
        const double share = most > 0.0 ? (cost - kUnit) / most : 0.0;
        costs.push_back(static_cast<std::uint8_t>(std::lround(252.0 * std::clamp(share, 0.0, 1.0))));
      } else if (map.at(column, row) < 0) {
        costs.push_back(kUnknownCost);
      } else {
        costs.push_back(grid.clearance(column + 1, row + 1) > 0.0F ? kInscribedCost : kLethalCost);
      }
    }
  }
  return costs;
}

}  // namespace bw
