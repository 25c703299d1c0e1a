// Paths held against the map, and what the planner pays for a cell. A floor of 10 x 6 m with cells of 0.1 m
// and a wall one cell thick from x = 5.0 to 5.1 m; a robot of 0.3 m.
#include "components/global_planner/path_check.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "components/global_planner/costs.hpp"
#include "components/global_planner/planner.hpp"
#include "components/model/cell_cost.hpp"

namespace bw {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const Footprint kDisc{0.3, {}};
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

OccupancyGrid floor_with_wall() {
  OccupancyGrid map{.resolution = 0.1, .origin = {0.0, 0.0}, .width = 100, .height = 60};
  map.cells.assign(6000, OccupancyGrid::kFree);
  for (int row = 0; row < map.height; ++row) map.cells[map.index(50, row)] = OccupancyGrid::kOccupied;
  return map;
}

Planner planner_on(const OccupancyGrid& map) {
  Planner planner;
  EXPECT_EQ(planner.set_map(map, kDisc), "");
  return planner;
}

/// At y = 3 m, x = 0.55, 1.55, ... 9.55.
std::vector<Pose2> along_the_floor() {
  std::vector<Pose2> path;
  for (int i = 0; i < 10; ++i) path.push_back({0.55 + i, 3.0, 0.0});
  return path;
}

// Clearance is the distance between centres less half a cell: at x = 4.75 it is 0.3 - 0.05 = 0.25 m, less
// than the radius; at 4.65 it is 0.35.
TEST(PathCheck, FindsPosesTooCloseToAnObstacle) {
  Planner planner = planner_on(floor_with_wall());
  std::vector<Pose2> path = along_the_floor();
  EXPECT_TRUE(planner.check(path, std::nullopt).valid);
  path[4].x = 4.65;
  EXPECT_TRUE(planner.check(path, std::nullopt).valid);
  path[4].x = 4.75;
  path[5].x = 5.05;
  const PathCheck check = planner.check(path, std::nullopt);
  EXPECT_FALSE(check.valid);
  EXPECT_THAT(check.blocked, ElementsAre(4, 5));
}

TEST(PathCheck, LooksAtWhatLiesAheadOfTheRobot) {
  Planner planner = planner_on(floor_with_wall());
  std::vector<Pose2> path = along_the_floor();
  path[2].y = -1.0;  // off the map
  EXPECT_THAT(planner.check(path, Vector2(2.5, 2.0)).blocked,
              ElementsAre(2));  // nearest: pose 1 at (1.55, 3)
  EXPECT_TRUE(planner.check(path, Vector2(3.4, 3.0)).valid);
  EXPECT_THAT(planner.check(path, std::nullopt).blocked, ElementsAre(2));
}

TEST(PathCheck, PeopleWhoStandBlockAPathAndAreForgotten) {
  Planner planner = planner_on(floor_with_wall());
  const std::vector<Pose2> path = along_the_floor();
  EXPECT_THAT(planner.check(path, std::nullopt, {{{7.5, 3.2}, 0.25}}).blocked, ElementsAre(7));
  EXPECT_TRUE(planner.check(path, std::nullopt).valid);
}

TEST(PathCheck, NothingIsNoPathAndNanIsNoPlace) {
  Planner planner = planner_on(floor_with_wall());
  EXPECT_FALSE(planner.check({}, std::nullopt).valid);
  EXPECT_THAT(planner.check({}, Vector2(1.0, 1.0)).blocked, IsEmpty());
  EXPECT_THAT(planner.check({{kNan, 3.0, 0.0}, {1.0, 3.0, 0.0}, {2.0, 3.0, kNan}}, std::nullopt).blocked,
              ElementsAre(0, 2));
  EXPECT_THAT(planner.check({{kNan, 3.0, 0.0}}, Vector2(1.0, 1.0)).blocked, ElementsAre(0));
  EXPECT_FALSE(Planner().check(along_the_floor(), std::nullopt).valid);  // no map
}

TEST(PathCheck, TakesHundredThousandPoses) {
  Planner planner = planner_on(floor_with_wall());
  std::vector<Pose2> path(100'000, Pose2{1.0, 3.0, 0.0});
  path.back().x = 5.05;
  EXPECT_THAT(planner.check(path, Vector2(1.0, 3.0)).blocked, ElementsAre(99'999));
}

// Clearance c costs 3 ((1 - c) / 0.7)^2 beyond a free cell, of at most 3: 252 ((1 - c) / 0.7)^2.
TEST(PlannerCosts, AreNav2sNumbers) {
  OccupancyGrid map = floor_with_wall();
  map.cells[map.index(0, 0)] = OccupancyGrid::kUnknown;
  const Planner planner = planner_on(map);
  const std::vector<std::uint8_t> costs =
      costs_of(planner.grid(), map, GlobalPlannerOptions().clearance_weight);
  ASSERT_EQ(costs.size(), map.cells.size());
  const auto at = [&](int column, int row) { return costs[map.index(column, row)]; };
  EXPECT_EQ(at(50, 30), kLethalCost);
  EXPECT_EQ(at(48, 30), kInscribedCost);
  EXPECT_EQ(at(47, 30), 252);        // at its far side there is 0.3 m
  EXPECT_EQ(at(46, 30), 217);        // 252 (0.65 / 0.7)^2
  EXPECT_EQ(at(43, 30), 63);         // 252 (0.35 / 0.7)^2
  EXPECT_EQ(at(39, 30), kFreeCost);  // 1.05 m
  EXPECT_EQ(at(0, 0), kUnknownCost);
}

}  // namespace
}  // namespace bw
