#include "components/people/detector/static_map.hpp"

#include <cmath>

#include "components/model/distance_transform.hpp"

namespace bw::people {

StaticMap::StaticMap(const OccupancyGrid& grid, double tolerance) {
  const bool sound =
      grid.width > 0 && grid.height > 0 && grid.resolution > 0.0 && grid.origin.allFinite() &&
      grid.cells.size() == static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height);
  if (!sound) return;
  resolution_ = grid.resolution;
  origin_ = grid.origin;
  width_ = grid.width;
  height_ = grid.height;
  const std::vector<float> distances = distance_field(grid, ObstacleRule{});
  near_.resize(distances.size());
  for (std::size_t i = 0; i < distances.size(); ++i) near_[i] = distances[i] <= tolerance;
}

bool StaticMap::contains(const Vector2& p_M) const {
  const double column = std::floor((p_M.x() - origin_.x()) / resolution_);
  const double row = std::floor((p_M.y() - origin_.y()) / resolution_);
  if (!(column >= 0.0 && row >= 0.0 && column < width_ && row < height_)) return false;
  return near_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(column)] != 0;
}

}  // namespace bw::people
