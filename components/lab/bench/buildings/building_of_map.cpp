#include "components/lab/bench/buildings/building_of_map.hpp"

#include "components/model/obstacle_rule.hpp"

namespace bw::buildings {
namespace {

// Borders along lines of the grid, those that follow each other as one wall. `differs(line, k)`: whether the k-th border
// on this line is one; `corner(line, k)`: where it begins.
template <class Differs, class Corner>
void add_walls(int lines, int borders, Differs differs, Corner corner, std::vector<Segment>& walls) {
  for (int line = 0; line <= lines; ++line) {
    int begin = -1;
    for (int k = 0; k <= borders; ++k) {
      const bool is_wall = k < borders && differs(line, k);
      if (is_wall && begin < 0) begin = k;
      if (!is_wall && begin >= 0) {
        walls.push_back({corner(line, begin), corner(line, k)});
        begin = -1;
      }
    }
  }
}

}  // namespace

Building building_of_map(const std::string& name, const OccupancyGrid& map, const Vector2& start) {
  constexpr ObstacleRule kRule{.unknown_is_obstacle = true};
  const auto is_free = [&](int column, int row) {
    return map.contains(column, row) && !kRule.blocks(map.at(column, row));
  };
  const auto corner = [&](int column, int row) -> Vector2 {
    return map.origin + map.resolution * Vector2{column, row};
  };
  Building building{.name = name, .walls = {}, .rooms = {}, .route = {start}};
  add_walls(
      map.height, map.width,
      [&](int row, int column) { return is_free(column, row - 1) != is_free(column, row); },
      [&](int row, int column) { return corner(column, row); }, building.walls);
  add_walls(
      map.width, map.height,
      [&](int column, int row) { return is_free(column - 1, row) != is_free(column, row); },
      [&](int column, int row) { return corner(column, row); }, building.walls);
  return building;
}

}  // namespace bw::buildings
