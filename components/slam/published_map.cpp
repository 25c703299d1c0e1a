#include "components/slam/published_map.hpp"

#include <algorithm>

namespace bw::slam {
namespace {

constexpr int kEdge = MapTile::kEdge;

bool says_something(const MapTile& tile) {
  return std::any_of(tile.cells.begin(), tile.cells.end(),
                     [](std::int8_t cell) { return cell != OccupancyGrid::kUnknown; });
}

}  // namespace

void PublishedMap::Box::add(int column, int row) {
  const bool first = empty();
  left = first ? column : std::min(left, column);
  low = first ? row : std::min(low, row);
  right = first ? column + 1 : std::max(right, column + 1);
  high = first ? row + 1 : std::max(high, row + 1);
}

PublishedMap::News PublishedMap::next(std::span<const MapTile> tiles) {
  Box drawn;
  for (const MapTile& tile : tiles)
    if (says_something(tile)) drawn.add(tile.column, tile.row);
  const bool resized = !drawn.empty() && grow_to_hold(drawn);
  for (const MapTile& tile : tiles)
    if (lay(tile)) changed_.add(tile.column, tile.row);
  ++intervals_;
  if (!resized && changed_.empty()) return News::none;
  if (!resized && intervals_ < kIntervalsPerMap) return News::part;
  changed_ = {};
  intervals_ = 0;
  return News::whole;
}

MapRegion PublishedMap::part() const {
  return {(changed_.left - box_.left) * kEdge, (changed_.low - box_.low) * kEdge,
          (changed_.right - changed_.left) * kEdge, (changed_.high - changed_.low) * kEdge};
}

bool PublishedMap::grow_to_hold(const Box& drawn) {
  Box wanted = box_;
  // The margin of a tile is kept free: a map that ends at a wall looks as if it went on behind it.
  const int step = std::max({1, (box_.right - box_.left) / 8, (box_.high - box_.low) / 8});
  const bool none = box_.empty();
  if (none || drawn.left - 1 < box_.left) wanted.left = drawn.left - (none ? 1 : step);
  if (none || drawn.low - 1 < box_.low) wanted.low = drawn.low - (none ? 1 : step);
  if (none || drawn.right + 1 > box_.right) wanted.right = drawn.right + (none ? 1 : step);
  if (none || drawn.high + 1 > box_.high) wanted.high = drawn.high + (none ? 1 : step);
  if (wanted.left == box_.left && wanted.low == box_.low && wanted.right == box_.right &&
      wanted.high == box_.high && !none)
    return false;
  OccupancyGrid larger;
  larger.resolution = grid_.resolution;
  larger.origin = {wanted.left * kEdge * grid_.resolution, wanted.low * kEdge * grid_.resolution};
  larger.width = (wanted.right - wanted.left) * kEdge;
  larger.height = (wanted.high - wanted.low) * kEdge;
  larger.cells.assign(static_cast<std::size_t>(larger.width) * static_cast<std::size_t>(larger.height),
                      OccupancyGrid::kUnknown);
  const int right_by = (box_.left - wanted.left) * kEdge;
  const int up_by = (box_.low - wanted.low) * kEdge;
  for (int row = 0; row < grid_.height; ++row)
    std::copy_n(&grid_.cells[grid_.index(0, row)], grid_.width,
                &larger.cells[larger.index(right_by, row + up_by)]);
  grid_ = std::move(larger);
  box_ = wanted;
  return true;
}

bool PublishedMap::lay(const MapTile& tile) {
  if (tile.column < box_.left || tile.row < box_.low || tile.column >= box_.right || tile.row >= box_.high)
    return false;  // nothing is known in it
  bool changed = false;
  for (int row = 0; row < kEdge; ++row) {
    const std::int8_t* from = &tile.cells[static_cast<std::size_t>(row) * kEdge];
    std::int8_t* to =
        &grid_.cells[grid_.index((tile.column - box_.left) * kEdge, (tile.row - box_.low) * kEdge + row)];
    if (std::equal(from, from + kEdge, to)) continue;
    std::copy_n(from, kEdge, to);
    changed = true;
  }
  return changed;
}

}  // namespace bw::slam
