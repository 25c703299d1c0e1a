#include "components/lab/bench/explore/growing_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bw {
namespace {

constexpr int kRays = 1440;
constexpr double kStep = 0.5;  // along a ray [cells]

}  // namespace

GrowingMap::GrowingMap(const Explorable& place, double range)
    : place_(place),
      reach_(range / place.truth.resolution),
      map_(place.truth),
      to_see_(static_cast<std::size_t>(std::ranges::count(place.cells, true))) {
  std::ranges::fill(map_.cells, OccupancyGrid::kUnknown);
}

void GrowingMap::look(explore::Cell from) {
  for (int k = 0; k < kRays; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kRays;
    const double dx = kStep * std::cos(angle);
    const double dy = kStep * std::sin(angle);
    double x = from.column + 0.5;
    double y = from.row + 0.5;
    for (double along = 0.0; along <= reach_; along += kStep, x += dx, y += dy) {
      const int column = static_cast<int>(x);
      const int row = static_cast<int>(y);
      if (!map_.contains(column, row)) break;
      const std::size_t i = map_.index(column, row);
      if (!is_known(i)) {
        map_.cells[i] = place_.truth.cells[i];
        if (place_.cells[i]) ++seen_;
      }
      if (place_.truth.cells[i] != OccupancyGrid::kFree) break;
    }
  }
}

}  // namespace bw
