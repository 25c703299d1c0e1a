#include "components/lab/bench/buildings/building_of_map.hpp"

#include <gtest/gtest.h>

#include "components/lab/bench/buildings/wall_index.hpp"

namespace bw::buildings {
namespace {

// Four by three cells of half a metre; one of those in the middle is occupied, one in a corner unknown.
OccupancyGrid small_map() {
  OccupancyGrid map;
  map.resolution = 0.5;
  map.origin = {10.0, -1.0};
  map.width = 4;
  map.height = 3;
  map.cells = {0, 0, 0, -1, 0, 100, 0, 0, 0, 0, 0, 0};
  return map;
}

double length(const std::vector<Segment>& walls) {
  double sum = 0.0;
  for (const Segment& wall : walls) sum += (wall.b - wall.a).norm();
  return sum;
}

// Around all of it 14 sides of half a metre, the unknown corner's two inner ones instead of its outer ones; four around
// the occupied cell.
TEST(BuildingOfMap, HasWallsWhereFreeCellsEnd) {
  const Building building = building_of_map("small", small_map(), {10.25, -0.75});
  EXPECT_DOUBLE_EQ(length(building.walls), 0.5 * (14 + 4));
  EXPECT_EQ(building.walls.size(), 4U + 2U + 4U) << "what follows each other is one";
  EXPECT_EQ(building.route, std::vector<Vector2>({{10.25, -0.75}}));
}

// From the lower left cell along +x three cells' widths less half a cell to the unknown one, and up to the occupied one
// from the cell below it.
TEST(BuildingOfMap, RaysEndAtTheBordersOfCells) {
  const Building building = building_of_map("small", small_map(), {10.25, -0.75});
  const WallIndex walls(building.walls);
  EXPECT_NEAR(walls.ray_hit({10.25, -0.75}, {1.0, 0.0}, 20.0), 1.25, 1e-9);
  EXPECT_NEAR(walls.ray_hit({10.75, -0.75}, {0.0, 1.0}, 20.0), 0.25, 1e-9);
}

}  // namespace
}  // namespace bw::buildings
