#include "components/model/distance_transform.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace bw {
namespace {

// Distance [cells] to the nearest obstacle in the same column; width + height where the column has none,
// which is more than any distance inside the grid.
void column_distances(const OccupancyGrid& grid, const ObstacleRule& rule, std::vector<std::int32_t>& d) {
  const auto width = static_cast<std::size_t>(grid.width);
  const auto height = static_cast<std::size_t>(grid.height);
  const std::int32_t none = grid.width + grid.height;
  d.resize(width * height);
  for (std::size_t i = 0; i < d.size(); ++i) d[i] = rule.blocks(grid.cells[i]) ? 0 : none;
  for (std::size_t i = width; i < d.size(); ++i) d[i] = std::min(d[i], d[i - width] + 1);
  for (std::size_t i = d.size(); i-- > width;) d[i - width] = std::min(d[i - width], d[i] + 1);
}

// The columns whose parabolas (x - i)^2 + g_i^2 form the lower envelope of one row, and where each takes
// over.
struct Envelope {
  std::vector<std::int64_t>& column;
  std::vector<std::int64_t>& from;
};

void build_envelope(const std::int32_t* g, std::int64_t width, const Envelope& e) {
  const auto value = [g](std::int64_t x, std::int64_t i) {
    return (x - i) * (x - i) + static_cast<std::int64_t>(g[i]) * g[i];
  };
  e.column.assign(1, 0);
  e.from.assign(1, 0);
  for (std::int64_t u = 1; u < width; ++u) {
    while (!e.column.empty() && value(e.from.back(), e.column.back()) > value(e.from.back(), u)) {
      e.column.pop_back();
      e.from.pop_back();
    }
    if (e.column.empty()) {
      e.column.push_back(u);
      e.from.push_back(0);
      continue;
    }
    const std::int64_t i = e.column.back();
    const std::int64_t gu = g[u];
    const std::int64_t gi = g[i];
    // Last x at which i is no worse than u; the numerator may be negative only when i was popped above.
    const std::int64_t takeover = 1 + (u * u - i * i + gu * gu - gi * gi) / (2 * (u - i));
    if (takeover < width) {
      e.column.push_back(u);
      e.from.push_back(takeover);
    }
  }
}

// Calls store(cell, squared distance) for every cell; below zero where the grid has no obstacle.
template <class Store>
void transform(const OccupancyGrid& grid, const std::vector<std::int32_t>& g, const Envelope& envelope,
               Store&& store) {
  const auto width = static_cast<std::int64_t>(grid.width);
  const std::int64_t none = static_cast<std::int64_t>(grid.width) + grid.height;
  for (int row = 0; row < grid.height; ++row) {
    const std::int32_t* g_row = g.data() + grid.index(0, row);
    build_envelope(g_row, width, envelope);
    std::size_t q = envelope.column.size();
    for (std::int64_t x = width; q-- > 0;) {
      const std::int64_t i = envelope.column[q];
      const std::int64_t squared_g = static_cast<std::int64_t>(g_row[i]) * g_row[i];
      for (; x > envelope.from[q]; --x) {
        const std::int64_t dx = x - 1 - i;
        const std::int64_t squared = dx * dx + squared_g;
        store(grid.index(static_cast<int>(x - 1), row), squared >= none * none ? -1 : squared);
      }
    }
  }
}

// So far [cells] a sum of two squares beyond the reach is still 16 bits wide.
constexpr int kShortReach = 90;

// nearest[x]: the least (x - i)^2 + g_i^2 of the columns i within `reach`; false where none is.
bool nearest_in_row(const std::int32_t* g, int width, int reach, std::vector<std::int16_t>& near,
                    std::vector<std::int16_t>& nearest) {
  const auto far = static_cast<std::int16_t>(reach * reach + 1);
  near.assign(static_cast<std::size_t>(width + 2 * reach), far);
  nearest.assign(static_cast<std::size_t>(width), far);
  bool is_any = false;
  for (int x = 0; x < width; ++x) {
    if (g[x] > reach) continue;
    near[static_cast<std::size_t>(x + reach)] = static_cast<std::int16_t>(g[x] * g[x]);
    is_any = true;
  }
  if (!is_any) return false;
  std::int16_t* const to = nearest.data();
  for (int dx = -reach; dx <= reach; ++dx) {
    const std::int16_t* from = near.data() + reach + dx;
    const auto squared_dx = static_cast<std::int16_t>(dx * dx);
    for (int x = 0; x < width; ++x) {
      const auto squared = static_cast<std::int16_t>(from[x] + squared_dx);
      to[x] = squared < to[x] ? squared : to[x];
    }
  }
  return true;
}

}  // namespace

std::vector<float> distance_field(const OccupancyGrid& grid, const ObstacleRule& rule) {
  std::vector<std::int32_t> g;
  std::vector<std::int64_t> column;
  std::vector<std::int64_t> from;
  column_distances(grid, rule, g);
  std::vector<float> distance(g.size());
  transform(grid, g, {column, from}, [&](std::size_t cell, std::int64_t squared) {
    distance[cell] = squared < 0
                         ? std::numeric_limits<float>::infinity()
                         : static_cast<float>(std::sqrt(static_cast<double>(squared)) * grid.resolution);
  });
  return distance;
}

const std::vector<std::int32_t>& DistanceTransform::squared_cells(const OccupancyGrid& grid,
                                                                  const ObstacleRule& rule, int reach) {
  column_distances(grid, rule, in_column_);
  if (reach > kShortReach) {
    const std::int32_t most = reach * reach;
    squared_.resize(in_column_.size());
    transform(grid, in_column_, {column_, from_}, [&](std::size_t cell, std::int64_t squared) {
      squared_[cell] = squared < 0 || squared > most ? kNone : static_cast<std::int32_t>(squared);
    });
    return squared_;
  }
  squared_.assign(in_column_.size(), kNone);
  const int within = std::min(reach, grid.width + grid.height - 1);  // less than of an empty column
  for (int row = 0; row < grid.height; ++row) {
    const std::size_t first = grid.index(0, row);
    if (!nearest_in_row(in_column_.data() + first, grid.width, within, near_, nearest_)) continue;
    for (std::size_t x = 0; x < nearest_.size(); ++x)
      if (nearest_[x] <= within * within) squared_[first + x] = nearest_[x];
  }
  return squared_;
}

}  // namespace bw
