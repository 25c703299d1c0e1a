#include "components/lab/bench/buildings/walkable_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "components/lab/bench/buildings/known_map.hpp"

namespace bw::buildings {
namespace {

constexpr double kCellSize = 0.15;  // [m]
// Half way between two diagonal neighbours a person is up to 0.02 m nearer to a corner.
constexpr double kCellClearance = kPersonClearance + 0.02;
constexpr double kStride = 0.05;  // between two looks on a straight part [m]
constexpr int kCutCells = 4;      // of the way, by which the next part is lengthened

constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();

}  // namespace

WalkableCells::WalkableCells(const Building& building, const WallIndex& walls)
    : walls_(walls), grid_(known_map(building, kCellSize)) {
  for (std::size_t i = 0; i < grid_.cells.size(); ++i) {
    if (grid_.cells[i] == OccupancyGrid::kFree &&
        walls_.clearance(center_of(i), kCellClearance) < kCellClearance)
      grid_.cells[i] = OccupancyGrid::kUnknown;
  }
  const std::vector<std::int32_t> reached = reach(nearest_cell(building.route.front()), kNowhere);
  for (std::size_t i = 0; i < reached.size(); ++i) {
    if (reached[i] >= 0) cells_.push_back(i);
    grid_.cells[i] = reached[i] >= 0 ? OccupancyGrid::kFree : OccupancyGrid::kUnknown;
  }
}

Vector2 WalkableCells::center_of(std::size_t cell) const {
  const auto width = static_cast<std::size_t>(grid_.width);
  return grid_.center(static_cast<int>(cell % width), static_cast<int>(cell / width));
}

Vector2 WalkableCells::drawn_place(Random& random) const {
  return center_of(cells_[static_cast<std::size_t>(random.uniform() * static_cast<double>(cells_.size()))]);
}

Vector2 WalkableCells::nearest_center(const Vector2& place) const { return center_of(nearest_cell(place)); }

std::size_t WalkableCells::nearest_cell(const Vector2& place) const {
  const int column = grid_.column_of(place.x());
  const int row = grid_.row_of(place.y());
  for (int reach = 2;; reach *= 2) {  // somewhere there is one
    std::size_t nearest = kNowhere;
    double least = std::numeric_limits<double>::infinity();
    for (int r = row - reach; r <= row + reach; ++r) {
      for (int c = column - reach; c <= column + reach; ++c) {
        if (!grid_.contains(c, r) || grid_.at(c, r) != OccupancyGrid::kFree) continue;
        const double distance = (grid_.center(c, r) - place).norm();
        if (distance >= least) continue;
        least = distance;
        nearest = grid_.index(c, r);
      }
    }
    if (nearest != kNowhere) return nearest;
  }
}

std::vector<std::int32_t> WalkableCells::reach(std::size_t first, std::size_t last) const {
  const std::int32_t w = grid_.width;
  // The grid has a border of cells that are not free: no neighbour is beyond it.
  const std::array<std::int32_t, 8> neighbours = {1, -1, w, -w, w + 1, w - 1, -w + 1, -w - 1};
  std::vector<std::int32_t> before(grid_.cells.size(), -1);
  std::vector<std::size_t> queue = {first};
  before[first] = static_cast<std::int32_t>(first);
  for (std::size_t i = 0; i < queue.size() && queue[i] != last; ++i) {
    for (const std::int32_t step : neighbours) {
      const auto next = static_cast<std::size_t>(static_cast<std::int64_t>(queue[i]) + step);
      if (grid_.cells[next] != OccupancyGrid::kFree || before[next] >= 0) continue;
      before[next] = static_cast<std::int32_t>(queue[i]);
      queue.push_back(next);
    }
  }
  return before;
}

bool WalkableCells::has_room_between(const Vector2& a, const Vector2& b) const {
  const int parts = static_cast<int>(std::ceil((b - a).norm() / kStride));
  for (int k = 1; k < parts; ++k) {
    const Vector2 place = a + (b - a) * (static_cast<double>(k) / parts);
    if (walls_.clearance(place, kCellClearance) < kCellClearance) return false;
  }
  return true;
}

std::vector<Vector2> WalkableCells::way(const Vector2& from, const Vector2& to) const {
  const std::size_t start = nearest_cell(from);
  const std::size_t end = nearest_cell(to);
  const std::vector<std::int32_t> before = reach(end, start);
  std::vector<Vector2> centers = {center_of(start)};
  for (std::size_t cell = start; cell != end; centers.push_back(center_of(cell)))
    cell = static_cast<std::size_t>(before[cell]);

  std::vector<Vector2> corners;
  for (std::size_t i = 0; i < centers.size(); ++i) {
    const Vector2& here = corners.empty() ? from : corners.back();
    std::size_t ahead = i;
    while (ahead + kCutCells < centers.size() && has_room_between(here, centers[ahead + kCutCells]))
      ahead += kCutCells;
    corners.push_back(centers[ahead]);
    i = ahead;
  }
  std::ranges::reverse(corners);
  return corners;
}

}  // namespace bw::buildings
