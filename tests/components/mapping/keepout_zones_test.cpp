#include "components/mapping/keepout_zones.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/components/mapping/grids.hpp"

namespace bw {
namespace {

KeepoutZones zones_of(const OccupancyGrid& mask) {
  KeepoutZones zones;
  EXPECT_EQ(zones.set_mask(mask), "");
  return zones;
}

/// Whether steps to the eight neighbours lead from the left rim to the right one without an occupied cell.
bool is_open(const OccupancyGrid& grid) {
  std::vector<std::pair<int, int>> open;
  std::vector<char> seen(grid.cells.size(), 0);
  for (int row = 0; row < grid.height; ++row) open.emplace_back(0, row);
  while (!open.empty()) {
    const auto [column, row] = open.back();
    open.pop_back();
    if (!grid.contains(column, row) || grid.at(column, row) == OccupancyGrid::kOccupied) continue;
    if (seen[grid.index(column, row)]++ != 0) continue;
    if (column == grid.width - 1) return true;
    // A planner cuts no corner between two occupied cells.
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
      open.emplace_back(column + dx, row + dy);
  }
  return false;
}

// Cells of 0.2 m over cells of 0.1 m, aside and beyond the map: the zone is the square from (0.24, 0.24) to
// (0.44, 0.44), which holds the middles 0.25 and 0.35 of columns and rows.
TEST(KeepoutZones, AreLaidOverAMapOfOtherCellsAndExtents) {
  OccupancyGrid mask = test::empty_grid(50, 50, 0.2, {-4.96, -4.96});
  mask.cells[mask.index(26, 26)] = OccupancyGrid::kOccupied;
  OccupancyGrid map = test::empty_grid(10, 10, 0.1);
  map.cells[map.index(9, 9)] = OccupancyGrid::kOccupied;
  map.cells[map.index(3, 3)] = OccupancyGrid::kUnknown;
  zones_of(mask).mark(map, {});
  std::vector<std::size_t> occupied;
  for (std::size_t i = 0; i < map.cells.size(); ++i)
    if (map.cells[i] == OccupancyGrid::kOccupied) occupied.push_back(i);
  EXPECT_EQ(occupied, (std::vector<std::size_t>{22, 23, 32, 33, 99}));
}

// A line of cells of 0.02 m through a map of cells of 0.1 m, in which no middle may lie on it, and of cells
// of 0.1 m through such of 0.03 m; both under any angle. Nobody gets across.
TEST(KeepoutZones, ALineOfCellsStaysClosedWhateverItsFrameAndItsCells) {
  for (const auto& [of_mask, of_map] : {std::pair{0.02, 0.1}, {0.1, 0.03}, {0.05, 0.05}}) {
    const int side = static_cast<int>(std::lround(8.0 / of_mask));
    OccupancyGrid mask = test::empty_grid(side, side, of_mask, {-4.0, -4.0});
    for (int row = 0; row < side; ++row) mask.cells[mask.index(side / 2, row)] = OccupancyGrid::kOccupied;
    const KeepoutZones zones = zones_of(mask);
    for (double degrees = 0.0; degrees < 45.0; degrees += 1.0) {
      const int count = static_cast<int>(std::lround(4.0 / of_map));
      OccupancyGrid map = test::empty_grid(count, count, of_map, {-2.0, -2.0});
      const Pose2 X_KM{0.013, -0.2, degrees * std::numbers::pi / 180.0};
      ASSERT_TRUE(is_open(map));
      zones.mark(map, X_KM);
      ASSERT_FALSE(is_open(map)) << of_mask << " in " << of_map << " at " << degrees << " degrees";
    }
  }
}

// The mask ends where its zone ends: 1 m by 1 m of cells that are all occupied. In F, whose origin is at
// (-2, 0) of the mask, its near side runs through the middles of the cells at x = 2.05.
TEST(KeepoutZones, AtTheRimOfTheMaskHaveOutlinesToo) {
  OccupancyGrid mask = test::empty_grid(10, 10, 0.1);
  for (auto& cell : mask.cells) cell = OccupancyGrid::kOccupied;
  StaticObstacles obstacles;
  zones_of(mask).add_to(obstacles, {1.0, 0.5}, {-2.0, 0.0, 0.0}, {});
  ASSERT_FALSE(obstacles.segments.empty());
  const Segment& nearest = obstacles.segments.front();
  EXPECT_NEAR(nearest.a.x(), 2.05, 1e-9);
  EXPECT_NEAR(nearest.b.x(), 2.05, 1e-9);
  EXPECT_TRUE(obstacles.points.empty());
}

// F is turned by a right angle about (1, 1): (0, 0.5) of F is (0.5, 1) of the mask.
TEST(KeepoutZones, ToARobotWithinItsPlaceIsAnObstacle) {
  OccupancyGrid mask = test::empty_grid(20, 20, 0.1);
  for (auto& cell : mask.cells) cell = OccupancyGrid::kOccupied;
  StaticObstacles obstacles;
  zones_of(mask).add_to(obstacles, {0.0, 0.5}, {1.0, 1.0, std::numbers::pi / 2.0}, {});
  ASSERT_EQ(obstacles.points.size(), 1U);
  EXPECT_NEAR((obstacles.points.front() - Vector2(0.0, 0.5)).norm(), 0.0, 1e-12);
}

TEST(KeepoutZones, AreThoseCellsThatAMapHasForObstacles) {
  OccupancyGrid mask{.resolution = 1.0, .width = 5, .height = 1, .cells = {-1, 0, 64, 65, 100}};
  KeepoutZones zones = zones_of(mask);
  for (int column = 0; column < 5; ++column)
    EXPECT_EQ(zones.hold({column + 0.5, 0.5}), column >= 3) << column;
  EXPECT_FALSE(zones.hold({5.5, 0.5}));
  EXPECT_FALSE(zones.hold({4.5, -0.5}));

  for (const int bad : {-128, -2, 101, 127}) {
    OccupancyGrid garbage = mask;
    garbage.cells = {0, 0, 0, static_cast<std::int8_t>(bad), 0};
    EXPECT_EQ(zones.set_mask(garbage),
              "a cell of it is " + std::to_string(bad) + ", which is neither -1 nor from 0 to 100");
    EXPECT_TRUE(zones.hold({4.5, 0.5}));
  }
  mask.cells = {-1, 0, 0, 0, 64};
  EXPECT_EQ(zones.set_mask(mask), "");
  EXPECT_TRUE(zones.empty());
}

}  // namespace
}  // namespace bw
