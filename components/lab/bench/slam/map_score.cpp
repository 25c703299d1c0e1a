#include "components/lab/bench/slam/map_score.hpp"

namespace bw::slam {
namespace {

bool is_occupied_around(const OccupancyGrid& grid, const Vector2& place) {
  const int column = grid.column_of(place.x());
  const int row = grid.row_of(place.y());
  for (int r = row - 1; r <= row + 1; ++r) {
    for (int c = column - 1; c <= column + 1; ++c) {
      if (grid.contains(c, r) && grid.at(c, r) == OccupancyGrid::kOccupied) return true;
    }
  }
  return false;
}

/// Occupied cells of `grid`, and those of them that `other` has too; X: the frame of `grid` in that of
/// `other`.
void compare(const OccupancyGrid& grid, const OccupancyGrid& other, const Pose2& X, std::size_t& all,
             std::size_t& matched) {
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      if (grid.at(column, row) != OccupancyGrid::kOccupied) continue;
      ++all;
      if (is_occupied_around(other, X * grid.center(column, row))) ++matched;
    }
  }
}

}  // namespace

MapScore score_map(const OccupancyGrid& made, const OccupancyGrid& truth, const Pose2& X_TM) {
  MapScore score;
  compare(made, truth, X_TM, score.drawn, score.right);
  compare(truth, made, inverse(X_TM), score.walls, score.found);
  return score;
}

}  // namespace bw::slam
