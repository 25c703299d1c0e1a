#include "components/mapping/map_part.hpp"

#include <cmath>
#include <stdexcept>

namespace bw {
namespace {

// [cells] a length that is a whole number of cells but for rounding gets no cell more.
constexpr double kRoundingOfCells = 1e-6;

}  // namespace

OccupancyGrid part_of(const OccupancyGrid& map, const MapPart& part, double max_cells) {
  if (!is_finite(part.corner) || !std::isfinite(part.length) || !std::isfinite(part.width))
    throw std::runtime_error("a number of the part is not finite");
  if (part.length <= 0.0 || part.width <= 0.0)
    throw std::runtime_error("length and width of the part must be positive");
  const Pose2 X_MN{0.0, 0.0, part.corner.theta};  // the new map in the old one
  Vector2 low = inverse(X_MN) * part.corner.position();
  Vector2 high = low + Vector2(part.length, part.width);
  if (part.corner.theta == 0.0) {
    const auto cells = [&](const Vector2& p) { return Vector2((p - map.origin) / map.resolution); };
    const Vector2 first = (cells(low).array() + kRoundingOfCells).floor();
    const Vector2 end = (cells(high).array() - kRoundingOfCells).ceil();
    low = map.origin + first * map.resolution;
    high = map.origin + end * map.resolution;
  }
  const Vector2 size = ((high - low).array() / map.resolution - kRoundingOfCells).ceil();
  if (size.x() * size.y() > max_cells) throw std::runtime_error("the part has too many cells");
  OccupancyGrid grid{.resolution = map.resolution,
                     .origin = low,
                     .width = static_cast<int>(size.x()),
                     .height = static_cast<int>(size.y())};
  grid.cells.reserve(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height));
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      const Vector2 p = (X_MN * grid.center(column, row) - map.origin) / map.resolution;
      const bool is_on_map = p.x() >= 0.0 && p.y() >= 0.0 && p.x() < map.width && p.y() < map.height;
      grid.cells.push_back(is_on_map ? map.at(static_cast<int>(p.x()), static_cast<int>(p.y()))
                                     : OccupancyGrid::kUnknown);
    }
  }
  return grid;
}

}  // namespace bw
