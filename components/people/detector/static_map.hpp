// Which positions lie on or near the walls of a map.
#pragma once

#include <cstdint>
#include <vector>

#include "components/model/occupancy_grid.hpp"

namespace bw::people {

class StaticMap {
 public:
  StaticMap() = default;
  /// `tolerance` [m] to the nearest occupied cell counts as wall. A grid whose sizes disagree is no map.
  StaticMap(const OccupancyGrid& grid, double tolerance);

  bool empty() const { return near_.empty(); }
  /// `p_M` in the map's frame; outside of it nothing is known, so nothing is wall.
  bool contains(const Vector2& p_M) const;

 private:
  double resolution_ = 1.0;
  Vector2 origin_{0.0, 0.0};
  int width_ = 0;
  int height_ = 0;
  std::vector<std::uint8_t> near_;
};

}  // namespace bw::people
