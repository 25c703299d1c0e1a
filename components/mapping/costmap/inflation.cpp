#include "components/mapping/costmap/inflation.hpp"

#include <cmath>

namespace bw::costmap {

std::uint8_t cost_at(double distance, double inscribed_radius, const InflationOptions& options) {
  if (distance <= 0.0) return kLethalCost;
  if (distance > options.inflation_radius) return kFreeCost;
  if (distance <= inscribed_radius) return kInscribedCost;
  return static_cast<std::uint8_t>((kInscribedCost - 1) *
                                   std::exp(-options.cost_scaling_factor * (distance - inscribed_radius)));
}

std::int8_t occupancy_of(std::uint8_t cost) {
  switch (cost) {
    case kFreeCost:
      return OccupancyGrid::kFree;
    case kUnknownCost:
      return OccupancyGrid::kUnknown;
    case kLethalCost:
      return OccupancyGrid::kOccupied;
    case kInscribedCost:
      return 99;
    default:
      return static_cast<std::int8_t>(1 + 97 * (cost - 1) / 251);
  }
}

Inflation::Inflation(const InflationOptions& options, double inscribed_radius, double resolution)
    : options_(options), reach_(static_cast<int>(std::ceil(options.inflation_radius / resolution))) {
  for (int squared = 0; squared <= reach_ * reach_; ++squared)
    table_.push_back(
        cost_at(std::sqrt(static_cast<double>(squared)) * resolution, inscribed_radius, options));
}

const std::vector<std::uint8_t>& Inflation::costs(const OccupancyGrid& grid) {
  const std::vector<std::int32_t>& squared = transform_.squared_cells(grid, {}, reach_);
  costs_.resize(squared.size());
  for (std::size_t i = 0; i < squared.size(); ++i) {
    const std::uint8_t cost =
        squared[i] != DistanceTransform::kNone ? table_[static_cast<std::size_t>(squared[i])] : kFreeCost;
    const std::uint8_t least = options_.inflate_unknown ? kFreeCost + 1 : kInscribedCost;
    const bool is_unknown = options_.track_unknown_space && grid.cells[i] < 0;
    costs_[i] = is_unknown && cost < least ? kUnknownCost : cost;
  }
  return costs_;
}

}  // namespace bw::costmap
