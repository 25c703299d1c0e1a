// Frontiers of maps that are drawn as text: '#' occupied, '.' free, ' ' unknown; cells of 0.1 m, the first row on top.
#include "components/explore/frontier_search.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace bw::explore {
namespace {

OccupancyGrid drawn(const std::vector<std::string>& rows) {
  OccupancyGrid grid;
  grid.resolution = 0.1;
  grid.width = static_cast<int>(rows.front().size());
  grid.height = static_cast<int>(rows.size());
  for (auto row = rows.rbegin(); row != rows.rend(); ++row)
    for (const char c : *row)
      grid.cells.push_back(c == '#'   ? OccupancyGrid::kOccupied
                           : c == '.' ? OccupancyGrid::kFree
                                      : OccupancyGrid::kUnknown);
  return grid;
}

// A room 2 m wide and 1 m deep inside its walls, whose right side is a door as wide as `door` cells, with some free
// floor behind it, and the unknown beyond.
OccupancyGrid room(int door) {
  std::vector<std::string> rows;
  rows.push_back(std::string(22, '#') + std::string(10, ' '));
  for (int row = 0; row < 10; ++row) {
    const bool is_open = row < door;
    rows.push_back("#" + std::string(20, '.') + (is_open ? "......" : "#     ") + std::string(5, ' '));
  }
  rows.push_back(rows.front());
  return drawn(rows);
}

constexpr FrontierOptions kRobot{.radius = 0.2, .least_length = 0.1};

TEST(FrontierSearch, AClosedRoomHasNone) {
  const FrontierSearch search = find_frontiers(room(0), {0.5, 0.6}, kRobot);
  EXPECT_TRUE(search.is_placed);
  EXPECT_TRUE(search.frontiers.empty());
  EXPECT_TRUE(search.out_of_reach.empty());
}

// The door is 1 m wide. Where the robot fits, 0.275 m from the walls' cells above and below (0.2 m and three quarters of
// a cell), five rows of the last free column are left. It may come as near to the unknown as to a wall: x of the goal is
// 2.45 of the last free cells' 2.65, since 2.75 is unknown.
TEST(FrontierSearch, BehindADoorThereIsOne) {
  const FrontierSearch search = find_frontiers(room(10), {0.5, 0.6}, kRobot);
  ASSERT_EQ(search.frontiers.size(), 1U);
  const Frontier& frontier = search.frontiers[0];
  EXPECT_NEAR(frontier.centre.x(), 2.65, 1e-9);
  EXPECT_NEAR(frontier.centre.y(), 0.6, 0.051);
  EXPECT_NEAR(frontier.goal.x, 2.45, 1e-9);
  EXPECT_NEAR(frontier.goal.theta, 0.0, 0.3);
  // From the cell at 0.45 or 0.55, straight.
  EXPECT_NEAR(frontier.path_length, 1.95, 0.1 + 1e-9);
}

// Through four cells of 0.1 m a disc of 0.4 m does not go, through seven it does.
TEST(FrontierSearch, AGapThatIsTooNarrowIsNone) {
  EXPECT_TRUE(find_frontiers(room(4), {0.5, 0.6}, kRobot).frontiers.empty());
  EXPECT_EQ(find_frontiers(room(7), {0.5, 0.6}, kRobot).frontiers.size(), 1U);
}

TEST(FrontierSearch, ShortOnesAreLeftOut) {
  const OccupancyGrid map = room(7);
  const double length = find_frontiers(map, {0.5, 0.6}, kRobot).frontiers.at(0).length;
  FrontierOptions options = kRobot;
  options.least_length = length + 0.01;
  EXPECT_TRUE(find_frontiers(map, {0.5, 0.6}, options).frontiers.empty());
}

// Every goal keeps the radius from all that is not known to be free, by brute force.
TEST(FrontierSearch, GoalsKeepClearOfWallsAndOfTheUnknown) {
  const OccupancyGrid map = room(10);
  for (const Frontier& frontier : find_frontiers(map, {0.5, 0.6}, kRobot).frontiers)
    for (int row = 0; row < map.height; ++row)
      for (int column = 0; column < map.width; ++column)
        if (map.at(column, row) != OccupancyGrid::kFree) {
          EXPECT_GT((map.center(column, row) - frontier.goal.position()).norm(), kRobot.radius + 0.05);
        }
}

// A frontier on the other side of a wall is not looked into from here, however near: there is none to drive to.
TEST(FrontierSearch, WhatLiesBehindAWallIsNotReached) {
  std::vector<std::string> rows(12, "#..........#..........     ");
  rows.front() = rows.back() = std::string(27, '#');
  const FrontierSearch search = find_frontiers(drawn(rows), {0.9, 0.6}, kRobot);
  EXPECT_TRUE(search.is_placed);
  EXPECT_TRUE(search.frontiers.empty());
}

TEST(FrontierSearch, OffTheMapTheRobotIsNotPlaced) {
  EXPECT_FALSE(find_frontiers(room(7), {9.0, 9.0}, kRobot).is_placed);
  EXPECT_FALSE(find_frontiers({}, {0.0, 0.0}, kRobot).is_placed);
}

}  // namespace
}  // namespace bw::explore
