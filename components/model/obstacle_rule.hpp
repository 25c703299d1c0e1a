// Which cells of an occupancy grid are in the way.
#pragma once

#include <cstdint>

#include "components/model/occupancy_grid.hpp"

namespace bw {

struct ObstacleRule {
  int occupied_at = 65;              ///< smallest occupancy [0 to 100] that is an obstacle
  bool unknown_is_obstacle = false;  ///< treat cells nobody has seen as obstacles

  bool blocks(std::int8_t value) const { return value < 0 ? unknown_is_obstacle : value >= occupied_at; }
};

}  // namespace bw
