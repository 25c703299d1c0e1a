// Frontiers of small maps whose numbers are reckoned by hand. The robot is a disc of 0.2 m, so that centres of cells
// must be 0.25 m apart from those of obstacles, which are half a cell around them.
#include "components/explore/frontier_search.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "components/explore/wavefront.hpp"
#include "components/model/random.hpp"
#include "tests/components/explore/explore_maps.hpp"

namespace bw::explore {
namespace {

using namespace test;

constexpr FrontierOptions kRobot{.radius = 0.2, .least_length = 0.1};
const Vector2 kStand{1.05, 1.45};

TEST(Wavefront, GoesStraightAndDiagonally) {
  const OccupancyGrid map = closed_room();
  const std::vector<bool> fits = cells_for_disc(map, 0.2, {.unknown_is_obstacle = true});
  const std::vector<Cell> start = cells_beside(map, fits, {1.05, 1.05}, 0.5);
  ASSERT_EQ(start.size(), 1U);
  const std::vector<double> length = wavefront(map, fits, start);
  // 10 cells along x and 5 along y: five diagonal steps and five straight ones.
  const Cell end{start[0].column + 10, start[0].row + 5};
  EXPECT_NEAR(length[map.index(end.column, end.row)], 0.1 * (5.0 + 5.0 * std::sqrt(2.0)), 1e-12);
  // The first cell in which the disc fits is 0.3 m from the middle of the wall: three cells in.
  EXPECT_FALSE(fits[map.index(map.column_of(0.15), map.row_of(1.05))]);
  EXPECT_TRUE(fits[map.index(map.column_of(0.25), map.row_of(1.05))]);
}

TEST(Wavefront, BeginsBesideARobotThatStandsTooNearToAWall) {
  // At 0.15 from a wall whose cells' middles are at -0.05: the cells from 0.25 on fit. Behind the wall there are others.
  OccupancyGrid map = closed_room();
  fill(map, -10, 0, -1, 30, OccupancyGrid::kFree);
  const std::vector<bool> fits = cells_for_disc(map, 0.2, {.unknown_is_obstacle = true});
  const std::vector<Cell> start = cells_beside(map, fits, {0.15, 1.45}, 0.5);
  ASSERT_FALSE(start.empty());
  for (const Cell cell : start) EXPECT_GT(map.center(cell.column, cell.row).x(), 0.2);
}

TEST(Frontiers, ADoor) {
  // A door of 1 m from y = 1 to 2: of its ten cells those from 1.25 to 1.75 are 0.25 m or more from the posts at 0.95
  // and 2.05, six of them.
  const FrontierSearch search = find_frontiers(room_with_door(10, 20), kStand, kRobot);
  EXPECT_TRUE(search.is_placed);
  ASSERT_EQ(search.frontiers.size(), 1U);
  EXPECT_TRUE(search.out_of_reach.empty());
  const Frontier& door = search.frontiers.front();
  EXPECT_NEAR(door.length, 0.6, 1e-9);
  EXPECT_NEAR(door.centre.x(), 4.05, 1e-9);
  EXPECT_NEAR(door.centre.y(), 1.45, 1e-9);
  // What is unknown begins with the cells at 4.15. With 0.15 m of room a goal is 0.4 m before: at 3.75. From 1.05 to
  // the centre there are 30 cells to go.
  EXPECT_NEAR(door.goal.x, 3.75, 1e-9);
  EXPECT_NEAR(door.goal.y, 1.45, 1e-9);
  EXPECT_NEAR(door.goal.theta, 0.0, 1e-9);
  EXPECT_NEAR(door.path_length, 3.0, 1e-9);
}

TEST(Frontiers, AGapNarrowerThanTheRobotIsNone) {
  // 0.4 m: posts at 1.25 and 1.75, no cell between them is 0.25 m from both. One cell more, and the middle is 0.3 m.
  EXPECT_TRUE(find_frontiers(room_with_door(13, 17), kStand, kRobot).frontiers.empty());
  EXPECT_TRUE(find_frontiers(room_with_door(13, 17), kStand, kRobot).out_of_reach.empty());
  EXPECT_EQ(find_frontiers(room_with_door(13, 18), kStand, kRobot).frontiers.size(), 1U);
}

TEST(Frontiers, NoneOfAClosedRoom) {
  const FrontierSearch search = find_frontiers(closed_room(), kStand, kRobot);
  EXPECT_TRUE(search.is_placed);
  EXPECT_TRUE(search.frontiers.empty());
  EXPECT_TRUE(search.out_of_reach.empty());
}

TEST(Frontiers, AGoalIsWhereThereIsRoomAndElseWhereItFits) {
  // A passage of 0.6 m to the door, from x = 2 on: nowhere in it there are 0.4 m to both sides, and the last cell with
  // 0.25 m before what is unknown is 3.85. From 2.65 on the room is farther off than 1.5 m.
  OccupancyGrid map = room_with_door(12, 18);
  fill(map, 20, 0, 41, 12, OccupancyGrid::kOccupied);
  fill(map, 20, 18, 41, 30, OccupancyGrid::kOccupied);
  const FrontierSearch search = find_frontiers(map, kStand, kRobot);
  ASSERT_EQ(search.frontiers.size(), 1U);
  EXPECT_NEAR(search.frontiers[0].goal.x, 3.85, 1e-9);
}

TEST(Frontiers, ShorterOnesThanTheLeastAreNone) {
  FrontierOptions longer = kRobot;
  longer.least_length = 0.7;  // the door's is 0.6
  EXPECT_TRUE(find_frontiers(room_with_door(10, 20), kStand, longer).frontiers.empty());
}

TEST(Frontiers, BehindAWallAreNoneOfTheRobots) {
  // A second room that is open to the right, seen through a gap that the robot does not fit through.
  OccupancyGrid map = room_with_door(13, 17);
  fill(map, 41, 0, 60, 30, OccupancyGrid::kFree);
  EXPECT_TRUE(find_frontiers(map, kStand, kRobot).frontiers.empty());
  const FrontierSearch from_there = find_frontiers(map, {5.05, 1.45}, kRobot);
  EXPECT_EQ(from_there.frontiers.size(), 1U);
}

TEST(Frontiers, TheNearestComesFirst) {
  OccupancyGrid map = room_with_door(10, 20);
  fill(map, -1, 10, 0, 20, OccupancyGrid::kFree);  // and one on the left
  const FrontierSearch search = find_frontiers(map, kStand, kRobot);
  ASSERT_EQ(search.frontiers.size(), 2U);
  EXPECT_LT(search.frontiers[0].centre.x(), 0.0);
  // From 1.05 to the last free cells, -0.05 and 4.05.
  EXPECT_NEAR(search.frontiers[0].path_length, 1.1, 1e-9);
  EXPECT_NEAR(search.frontiers[1].path_length, 3.0, 1e-9);
}

TEST(Frontiers, WhatNoKnownGroundLeadsToIsTold) {
  // A strip of 0.3 m that one beam has cleared, to a bay of 0.3 m: nowhere there the robot stands clear of what is unknown.
  // Its cells are one frontier with the strip, and that begins beside the room.
  OccupancyGrid map = closed_room();
  fill(map, 40, 5, 41, 25, OccupancyGrid::kFree);
  fill(map, 41, 14, 80, 17, OccupancyGrid::kFree);
  const FrontierSearch search = find_frontiers(map, kStand, kRobot);
  ASSERT_EQ(search.frontiers.size(), 1U);
  EXPECT_LT(search.frontiers[0].goal.x, 4.0);
  // Cut off by a metre of what only just lets the robot through: walls on both sides, so that nothing there is a frontier.
  OccupancyGrid cut = closed_room();
  fill(cut, 40, 11, 60, 19, OccupancyGrid::kOccupied);
  fill(cut, 40, 12, 60, 18, OccupancyGrid::kFree);
  fill(cut, 60, 12, 80, 18, OccupancyGrid::kFree);
  fill(cut, 60, 12, 63, 18, OccupancyGrid::kFree);
  const FrontierSearch open = find_frontiers(cut, kStand, kRobot);
  ASSERT_EQ(open.frontiers.size() + open.out_of_reach.size(), 1U);
}

TEST(Frontiers, WithoutGroundUnderTheRobotNothingIsSaid) {
  EXPECT_FALSE(find_frontiers(closed_room(), {7.0, 3.0}, kRobot).is_placed);
  EXPECT_FALSE(find_frontiers(OccupancyGrid{}, kStand, kRobot).is_placed);
  // Beside a wall, where it does not fit by the map: from half a metre to where it does.
  EXPECT_TRUE(find_frontiers(closed_room(), {0.05, 1.45}, kRobot).is_placed);
}

// Maps with random boxes and holes of what is unknown.
class RandomMap : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  static OccupancyGrid map() {
    Random random(GetParam());
    OccupancyGrid map = room_with_door(10, 20);
    for (int k = 0; k < 12; ++k) {
      const int left = static_cast<int>(random.uniform(0.0, 36.0));
      const int low = static_cast<int>(random.uniform(0.0, 26.0));
      const auto value = k % 2 == 0 ? OccupancyGrid::kOccupied : OccupancyGrid::kUnknown;
      fill(map, left, low, left + 3, low + 3, value);
    }
    fill(map, 9, 13, 13, 17, OccupancyGrid::kFree);
    return map;
  }
};

TEST_P(RandomMap, GoalsAreOnKnownFreeGroundWithRoomForTheRobot) {
  const OccupancyGrid grid = map();
  for (const Frontier& frontier : find_frontiers(grid, kStand, kRobot).frontiers) {
    for (int row = 0; row < grid.height; ++row) {
      for (int column = 0; column < grid.width; ++column) {
        const double away = (grid.center(column, row) - frontier.goal.position()).norm();
        if (away >= 0.2 + 0.5 * kEdge) continue;
        EXPECT_EQ(grid.at(column, row), OccupancyGrid::kFree);
      }
    }
  }
}

TEST_P(RandomMap, SameMapSameFrontiers) {
  const FrontierSearch a = find_frontiers(map(), kStand, kRobot);
  const FrontierSearch b = find_frontiers(map(), kStand, kRobot);
  ASSERT_EQ(a.frontiers.size(), b.frontiers.size());
  for (std::size_t k = 0; k < a.frontiers.size(); ++k) {
    EXPECT_EQ(a.frontiers[k].centre, b.frontiers[k].centre);
    EXPECT_EQ(a.frontiers[k].path_length, b.frontiers[k].path_length);
    EXPECT_EQ(a.frontiers[k].goal.theta, b.frontiers[k].goal.theta);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomMap, ::testing::Range<std::uint64_t>(1, 11));

}  // namespace
}  // namespace bw::explore
