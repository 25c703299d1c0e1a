#include "components/lab/bench/buildings/known_map.hpp"

#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/components/lab/bench/buildings/test_rooms.hpp"

namespace bw::buildings {
namespace {

// A room of 80 x 60 cells whose walls lie in the middle of cells: 79 x 59 cells are inside, and the ring
// around them has 81 x 61 less those. In it a cupboard of 20 x 20 likewise: a ring of 80 cells around 19 x
// 19 that nobody sees.
TEST(KnownMap, CountsOfARoomWithACupboard) {
  Building building = rectangular_room(4.0, 3.0);
  for (const Vector2& shift : {Vector2(1.0, 0.0), Vector2(1.0, 1.0), Vector2(0.0, 1.0), Vector2(0.0, 0.0)}) {
    const Vector2 turned(-shift.y() + 1.0, shift.x());
    building.walls.push_back({Vector2(1.0, 1.0) + shift, Vector2(1.0, 1.0) + turned});
  }
  for (Segment& wall : building.walls) {
    wall.a += Vector2::Constant(0.025);
    wall.b += Vector2::Constant(0.025);
  }
  building.route = {{3.0, 1.5}, {3.0, 2.5}};
  const OccupancyGrid map = known_map(building);
  EXPECT_EQ(std::ranges::count(map.cells, OccupancyGrid::kFree), 79 * 59 - 21 * 21);
  EXPECT_EQ(std::ranges::count(map.cells, OccupancyGrid::kOccupied), 81 * 61 - 79 * 59 + 80);
  const auto at = [&](double x, double y) { return map.at(map.column_of(x), map.row_of(y)); };
  EXPECT_EQ(at(0.5, 0.5), OccupancyGrid::kFree);
  EXPECT_EQ(at(1.525, 1.525), OccupancyGrid::kUnknown);  // in the cupboard
  EXPECT_EQ(at(4.1, 1.5), OccupancyGrid::kUnknown);
  EXPECT_EQ(at(4.025, 1.5), OccupancyGrid::kOccupied);

  building.route = {{4.025, 1.5}, {3.0, 1.5}};
  EXPECT_THROW(known_map(building), std::invalid_argument);
}

// The flood must not leak: a border of the grid is left unknown, and the whole route is free.
TEST(KnownMap, OfBuildingsIsClosedAndHasTheRouteFree) {
  for (const BuildingKind kind : kBuildingKinds) {
    const Building building = make_building(kind, 2);
    SCOPED_TRACE(building.name);
    const OccupancyGrid map = known_map(building);
    for (int column = 0; column < map.width; ++column) {
      EXPECT_EQ(map.at(column, 0), OccupancyGrid::kUnknown);
      EXPECT_EQ(map.at(column, map.height - 1), OccupancyGrid::kUnknown);
    }
    for (const Vector2& corner : building.route)
      EXPECT_EQ(map.at(map.column_of(corner.x()), map.row_of(corner.y())), OccupancyGrid::kFree);
  }
}

}  // namespace
}  // namespace bw::buildings
