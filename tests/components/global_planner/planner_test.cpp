#include "components/global_planner/planner.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "components/mapping/rasterize.hpp"
#include "components/model/random.hpp"
#include "tests/components/global_planner/random_floor.hpp"

namespace bw {
namespace {

const Footprint kRobot{0.3, {}};

OccupancyGrid open_floor(double width, double height) {
  OccupancyGrid map{
      .resolution = 0.05, .width = static_cast<int>(width / 0.05), .height = static_cast<int>(height / 0.05)};
  map.cells.assign(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height),
                   OccupancyGrid::kFree);
  return map;
}

// 10 x 6 m, parted by a wall at x = 5 m with one door between y = 4 and y = 5.
OccupancyGrid two_rooms() {
  OccupancyGrid map = open_floor(10.0, 6.0);
  draw_segment(map, {{5.0, 0.0}, {5.0, 4.0}});
  draw_segment(map, {{5.0, 5.0}, {5.0, 6.0}});
  return map;
}

Planner planner_on(const OccupancyGrid& map, GlobalPlannerOptions options = {}) {
  Planner planner(options);
  EXPECT_EQ(planner.set_map(map, kRobot), "");
  return planner;
}

// The shortest path around the door's lower post is longer than 8 m and shorter than the octile detour
// through (5, 4.5).
TEST(Planner, GoesThroughTheDoor) {
  Planner planner = planner_on(two_rooms());
  const PathResult result = planner.plan({1.0, 1.0, 0.3}, {9.0, 1.0, 2.0});
  ASSERT_EQ(result.status, PathStatus::ok) << result.reason;
  EXPECT_GT(result.length, 2.0 * std::hypot(4.0, 3.0));
  EXPECT_LT(result.length, 2.0 * (4.0 * (std::numbers::sqrt2 - 1.0) + 4.0) + 1.0);
  EXPECT_EQ(result.goal_offset, 0.0);
  EXPECT_EQ(result.path.front().position(), Vector2(1.0, 1.0));
  EXPECT_EQ(result.path.back(), (Pose2{9.0, 1.0, 2.0}));
  for (std::size_t i = 1; i < result.path.size(); ++i) {
    const Vector2 d = result.path[i].position() - result.path[i - 1].position();
    EXPECT_LE(d.norm(), 0.1 + 1e-9);
    EXPECT_NEAR(wrap_angle(std::atan2(d.y(), d.x()) - result.path[i - 1].theta), 0.0, 1e-6);
  }
}

TEST(Planner, SaysWhyThereIsNoPath) {
  OccupancyGrid map = two_rooms();
  draw_box(map, {1.0, 4.0}, {2.0, 5.0});
  Planner planner = planner_on(map);
  const Pose2 left{1.0, 1.0, 0.0};
  const Pose2 right{9.0, 1.0, 0.0};
  const Pose2 in_box{1.5, 4.5, 0.0};
  EXPECT_EQ(planner.plan(in_box, right).status, PathStatus::start_blocked);
  EXPECT_EQ(planner.plan(left, in_box).status, PathStatus::goal_blocked);
  EXPECT_EQ(planner.plan({-1.0, 1.0, 0.0}, right).status, PathStatus::start_outside);
  EXPECT_EQ(planner.plan(left, {9.0, 6.5, 0.0}).status, PathStatus::goal_outside);
  EXPECT_EQ(planner.plan({1e300, 1.0, 0.0}, right).status, PathStatus::start_outside);
  draw_segment(map, {{5.0, 4.0}, {5.0, 5.0}});
  ASSERT_EQ(planner.set_map(map, kRobot), "");
  const PathResult result = planner.plan(left, right);
  EXPECT_EQ(result.status, PathStatus::disconnected);
  EXPECT_EQ(result.expanded, 0u);  // known from the components, without a search
  EXPECT_EQ(result.reason, "goal (9.00, 1.00) is free, but no way leads there from the start");
}

// Legs of 4 m, 2 m and 4 m on an open floor: straight lines, each pose of the path once, the headings of the
// stops kept.
TEST(Planner, PlansThroughStopsInTheirOrder) {
  Planner planner = planner_on(open_floor(10.0, 6.0));
  const std::vector<Pose2> stops{{5.0, 2.0, 1.0}, {5.0, 4.0, 2.0}, {1.0, 4.0, 3.0}};
  const PathResult result = planner.plan_through({1.0, 2.0, 0.0}, stops);
  ASSERT_EQ(result.status, PathStatus::ok) << result.reason;
  EXPECT_NEAR(result.length, 10.0, 1e-9);
  ASSERT_EQ(result.path.size(), 101u);
  EXPECT_EQ(result.path[40], stops[0]);
  EXPECT_EQ(result.path[60], stops[1]);
  EXPECT_EQ(result.path[100], stops[2]);
  // A stop where the last one was is a rotation there.
  const PathResult rotation = planner.plan_through({1.0, 2.0, 0.0}, {{5.0, 2.0, 1.0}, {5.0, 2.0, 2.0}});
  ASSERT_EQ(rotation.path.size(), 41u);
  EXPECT_EQ(rotation.path.back(), (Pose2{5.0, 2.0, 2.0}));
}

TEST(Planner, APathThroughStopsIsWholeOrNotThere) {
  Planner planner = planner_on(two_rooms());
  const Pose2 start{1.0, 1.0, 0.0}, near{3.0, 1.0, 0.0}, in_wall{5.0, 2.0, 0.0};
  const PathResult result = planner.plan_through(start, {near, in_wall, near});
  EXPECT_EQ(result.status, PathStatus::goal_blocked);
  EXPECT_EQ(result.reason, "on the way to pose 2 of 3: goal (5.00, 2.00) is too close to an obstacle");
  EXPECT_TRUE(result.path.empty());
  EXPECT_EQ(planner.plan_through(start, {}).status, PathStatus::bad_request);
}

TEST(Planner, RefusesNumbersThatAreNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(Planner().plan({}, {}).status, PathStatus::no_map);
  Planner planner = planner_on(two_rooms());
  EXPECT_EQ(planner.plan({nan, 1.0, 0.0}, {1.0, 1.0, 0.0}).status, PathStatus::bad_request);
  EXPECT_EQ(planner.plan({1.0, 1.0, 0.0}, {1.0, 1.0, std::numeric_limits<double>::infinity()}).status,
            PathStatus::bad_request);
  EXPECT_EQ(planner.plan({1.0, 1.0, 0.0}, {2.0, 1.0, 0.0}, {{{nan, 0.0}, 0.3}}).status,
            PathStatus::bad_request);
}

TEST(Planner, RefusesMapsThatMakeNoSense) {
  Planner planner;
  EXPECT_NE(planner.set_map({}, kRobot), "");
  OccupancyGrid map = open_floor(1.0, 1.0);
  map.cells.pop_back();
  EXPECT_NE(planner.set_map(map, kRobot), "");
  map = open_floor(1.0, 1.0);
  map.resolution = 0.0;
  EXPECT_NE(planner.set_map(map, kRobot), "");
  EXPECT_NE(planner.set_map(open_floor(1.0, 1.0), Footprint{std::numeric_limits<double>::quiet_NaN(), {}}),
            "");
  EXPECT_EQ(planner.plan({}, {}).status, PathStatus::no_map);
}

// The wall stands at x = 5.0 to 5.05 m; a robot 0.2 m before it is inside the inflation (0.3 m). It must
// leave on its own side, although the free cells behind the wall are nearly as close.
TEST(Planner, StartsInsideTheInflationOnTheRightSideOfTheWall) {
  OccupancyGrid map = open_floor(10.0, 6.0);
  draw_segment(map, {{5.0, 0.0}, {5.0, 6.0}});
  Planner planner = planner_on(map, {.start_tolerance = 1.0});
  const PathResult result = planner.plan({4.8, 3.0, 0.0}, {1.0, 3.0, 0.0});
  ASSERT_EQ(result.status, PathStatus::ok) << result.reason;
  EXPECT_EQ(result.path.front().position(), Vector2(4.8, 3.0));
  for (const Pose2& pose : result.path) EXPECT_LE(pose.x, 4.8 + 1e-9);
  EXPECT_EQ(planner.plan({4.8, 3.0, 0.0}, {9.0, 3.0, 0.0}).status, PathStatus::disconnected);
  Planner strict = planner_on(map, {.start_tolerance = 0.0});
  EXPECT_EQ(strict.plan({4.8, 3.0, 0.0}, {1.0, 3.0, 0.0}).status, PathStatus::start_blocked);
}

// A goal 0.1 m before a wall: the nearest cell with 0.3 m clearance is 0.2 m away, found within one cell.
TEST(Planner, MovesABlockedGoalWithinTheTolerance) {
  OccupancyGrid map = open_floor(10.0, 6.0);
  draw_segment(map, {{5.0, 0.0}, {5.0, 6.0}});
  Planner planner = planner_on(map, {.goal_tolerance = 0.3});
  const PathResult result = planner.plan({1.0, 3.0, 0.0}, {4.9, 3.0, 0.5});
  ASSERT_EQ(result.status, PathStatus::ok) << result.reason;
  EXPECT_NEAR(result.goal_offset, 0.2, 0.06);
  EXPECT_DOUBLE_EQ(result.path.back().theta, 0.5);
  EXPECT_NEAR(result.path.back().x, 4.7, 0.06);
  Planner strict = planner_on(map, {.goal_tolerance = 0.1});
  EXPECT_EQ(strict.plan({1.0, 3.0, 0.0}, {4.9, 3.0, 0.5}).status, PathStatus::goal_blocked);
}

// A person (0.3 m) stands on the straight line: the path keeps 0.6 m of centre distance, and the map is as
// before after.
TEST(Planner, GoesAroundTemporaryDiscsAndForgetsThem) {
  Planner planner = planner_on(open_floor(10.0, 6.0));
  const Pose2 start{1.0, 3.0, 0.0};
  const Pose2 goal{9.0, 3.0, 0.0};
  const PathResult before = planner.plan(start, goal);
  const Disc person{{5.0, 3.0}, 0.3};
  const PathResult around = planner.plan(start, goal, {person, {{5.2, 3.1}, 0.3}});
  ASSERT_EQ(around.status, PathStatus::ok) << around.reason;
  EXPECT_GT(around.length, before.length);
  for (const Pose2& pose : around.path) EXPECT_GE((pose.position() - person.center).norm(), 0.6 - 0.05);
  EXPECT_EQ(planner.plan(start, goal).path, before.path);
}

TEST(Planner, SaysWhenTemporaryDiscsBlockTheOnlyDoor) {
  Planner planner = planner_on(two_rooms());
  const Pose2 start{1.0, 1.0, 0.0};
  const Pose2 goal{9.0, 1.0, 0.0};
  const PathResult blocked = planner.plan(start, goal, {{{5.0, 4.5}, 0.4}});
  EXPECT_EQ(blocked.status, PathStatus::disconnected);
  EXPECT_NE(blocked.reason.find("temporary"), std::string::npos);
  EXPECT_EQ(planner.plan(start, goal).status, PathStatus::ok);
  EXPECT_EQ(planner.plan(start, goal, {{{5.0, 3.0}, 1e9}}).status, PathStatus::start_blocked);
  EXPECT_EQ(planner.plan(start, goal).status, PathStatus::ok);
}

TEST(Planner, BlocksUnknownCellsUnlessToldOtherwise) {
  OccupancyGrid map = open_floor(10.0, 6.0);
  for (int row = 0; row < map.height; ++row) map.cells[map.index(100, row)] = OccupancyGrid::kUnknown;
  Planner careful = planner_on(map);
  EXPECT_EQ(careful.plan({1.0, 3.0, 0.0}, {9.0, 3.0, 0.0}).status, PathStatus::disconnected);
  Planner bold = planner_on(map, {.unknown_is_obstacle = false});
  EXPECT_EQ(bold.plan({1.0, 3.0, 0.0}, {9.0, 3.0, 0.0}).status, PathStatus::ok);
}

// The door of 1 m leaves 0.4 m for a robot of 0.3 m: the path is in the middle 0.4 m of it and, with the
// clearance cost, within 0.1 m of the centre.
TEST(Planner, KeepsToTheMiddleOfADoor) {
  Planner planner = planner_on(two_rooms());
  const PathResult result = planner.plan({1.0, 4.5, 0.0}, {9.0, 3.0, 0.0});
  ASSERT_EQ(result.status, PathStatus::ok) << result.reason;
  for (const Pose2& pose : result.path) {
    if (std::abs(pose.x - 5.0) > 0.1) continue;
    EXPECT_NEAR(pose.y, 4.5, 0.125);
  }
}

TEST(Planner, AnswersEqualRequestsEqually) {
  Random random(4);
  const OccupancyGrid map = test::random_floor(random, 300);
  Planner one = planner_on(map);
  Planner other = planner_on(map);
  for (int i = 0; i < 20; ++i) {
    const test::Trip trip = test::random_trip(random, one.grid(), map);
    const PathResult a = one.plan(trip.start, trip.goal);
    const PathResult b = other.plan(trip.start, trip.goal);
    ASSERT_EQ(a.status, PathStatus::ok);
    EXPECT_EQ(a.path, b.path);
    EXPECT_EQ(one.plan(trip.start, trip.goal).path, a.path);
  }
}

// A message that is no map must not take away the one that is.
TEST(Planner, KeepsItsMapWhenAnotherIsRefused) {
  Planner planner = planner_on(two_rooms());
  OccupancyGrid broken = open_floor(1.0, 1.0);
  broken.cells.pop_back();
  EXPECT_NE(planner.set_map(broken, kRobot), "");
  EXPECT_EQ(planner.plan({1.0, 1.0, 0.3}, {9.0, 1.0, 2.0}).status, PathStatus::ok);
}

// A map of another size, origin and resolution counts from the next plan on.
TEST(Planner, TakesAnotherMap) {
  Planner planner = planner_on(two_rooms());
  OccupancyGrid moved = open_floor(2.0, 2.0);
  moved.origin = {100.0, -50.0};
  moved.resolution = 0.1;
  EXPECT_EQ(planner.set_map(moved, kRobot), "");
  EXPECT_EQ(planner.plan({1.0, 1.0, 0.3}, {9.0, 1.0, 2.0}).status, PathStatus::start_outside);
  EXPECT_EQ(planner.plan({101.0, -49.0, 0.0}, {103.0, -47.0, 0.0}).status, PathStatus::ok);
}

}  // namespace
}  // namespace bw
