#include "components/explore/beam_gaps.hpp"

#include <cmath>
#include <cstddef>

#include "components/model/obstacle_rule.hpp"

namespace bw::explore {
namespace {

/// One row or column of `map`: `count` cells from `first` on, `step` apart.
void close_line(const OccupancyGrid& map, std::size_t first, std::size_t step, int count, int most,
                OccupancyGrid& closed) {
  constexpr ObstacleRule kObstacle{};
  int last_free = count;  // none yet
  for (int k = 0; k < count; ++k) {
    const std::int8_t value = map.cells[first + static_cast<std::size_t>(k) * step];
    if (value < 0) continue;
    if (kObstacle.blocks(value)) {
      last_free = count;
      continue;
    }
    if (last_free < k && k - last_free - 1 <= most)
      for (int gap = last_free + 1; gap < k; ++gap)
        closed.cells[first + static_cast<std::size_t>(gap) * step] = OccupancyGrid::kFree;
    last_free = k;
  }
}

}  // namespace

OccupancyGrid without_beam_gaps(const OccupancyGrid& map, double width) {
  const int most = static_cast<int>(std::floor(width / map.resolution + 1e-9));
  OccupancyGrid closed = map;
  for (int row = 0; row < map.height; ++row) close_line(map, map.index(0, row), 1, map.width, most, closed);
  for (int column = 0; column < map.width; ++column)
    close_line(map, map.index(column, 0), static_cast<std::size_t>(map.width), map.height, most, closed);
  return closed;
}

}  // namespace bw::explore
