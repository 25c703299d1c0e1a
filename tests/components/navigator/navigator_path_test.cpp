// The path to a goal: through poses, how much of it is left, how well it is kept.
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/components/navigator/navigator_drive.hpp"

namespace bw {
namespace {

// Via poses at 3 and 6 m on the way to 10 m, at 1 m/s: passed at 2.3 and 5.3 m, 0.7 m before them.
TEST(Navigator, DrivesThroughPosesWithoutAStop) {
  Drive drive;
  drive.go_through({{3, 0, 0}, {6, 0, 0}}, 10.0);
  EXPECT_EQ(drive.plans.front().via.size(), 2U);
  std::vector<double> passed_at;
  std::size_t remaining = 3;
  while (drive.navigator.has_goal() && drive.x < 9.9) {
    drive.run(0.05);
    if (drive.poses_remaining() == remaining) continue;
    remaining = drive.poses_remaining();
    passed_at.push_back(drive.x);
  }
  EXPECT_THAT(passed_at,
              ::testing::ElementsAre(::testing::DoubleNear(2.3, 0.051), ::testing::DoubleNear(5.3, 0.051)));
  EXPECT_EQ(drive.count(FollowMode::stop), 0);
  EXPECT_THAT(drive.plans.back().via, ::testing::IsEmpty());
  drive.run(1.0);
  EXPECT_EQ(drive.last().status, GoalStatus::succeeded);
  EXPECT_NEAR(drive.last().navigation_time.to_seconds(), 10.0, 0.11);
}

TEST(Navigator, PosesArePassedInTheirOrder) {
  Drive drive;
  drive.go_through({{8, 0, 0}, {2, 0, 0}}, 10.0);
  drive.run(4.0);  // past the second, whose turn it is not
  EXPECT_EQ(drive.poses_remaining(), 3U);
  drive.run(4.0);
  EXPECT_EQ(drive.poses_remaining(), 2U);
}

TEST(Navigator, AGoalWhereTheRobotStandsIsReachedOnlyThroughItsPoses) {
  Drive drive;
  const std::uint64_t id = drive.go_through({{5, 0, 0}}, 0.0);
  drive.goal_x.reset();
  drive.run(3.0);
  EXPECT_TRUE(drive.navigator.has_goal());
  drive.run(1.5);
  EXPECT_EQ(drive.poses_remaining(), 1U);
  drive.speed = -1.0;
  while (drive.x > 0.2) drive.run(0.05);
  drive.v = drive.speed = 0.0;
  drive.run(0.05);
  EXPECT_EQ(drive.last().goal_id, id);
  EXPECT_EQ(drive.last().status, GoalStatus::succeeded);
}

// 4 m out and back again: at 1 m on the way out 3 m and 4 m are left, on the way back 1 m.
TEST(Navigator, DistanceRemainingKnowsWhichStretchIsDriven) {
  std::vector<Pose2> path;
  for (int i = 0; i <= 40; ++i) path.push_back({0.1 * i, 0, 0});
  for (int i = 39; i >= 0; --i) path.push_back({0.1 * i, 0, 0});
  EXPECT_NEAR(remaining_length(path, {1.0, 0.0}, {{4, 0, 0}}), 7.0, 1e-9);
  EXPECT_NEAR(remaining_length({path.begin() + 40, path.end()}, {1.0, 0.0}), 1.0, 1e-9);
  // The way back leads by 0.1 m to the left: nearer to the robot, which is on the way out.
  for (int i = 41; i <= 80; ++i) path[static_cast<std::size_t>(i)].y = 0.1;
  EXPECT_NEAR(tracking_error(path, {1.0, 0.2, 0.1}, {{4, 0, 0}}).heading, -0.1, 1e-9);
  EXPECT_NEAR(straight_length({0, 0}, {{4, 0, 0}, {4, 3, 0}}, {0, 0, 0}), 4.0 + 3.0 + 5.0, 1e-9);
}

TEST(Navigator, TracksItsPathWithTheSignsOfNav2) {
  const std::vector<Pose2> path = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const TrackingError error = tracking_error(path, {1.2, 0.3, 0.1});
  EXPECT_NEAR(error.position, 0.3, 1e-12);
  EXPECT_NEAR(error.heading, -0.1, 1e-12);
  EXPECT_NEAR(tracking_error(path, {2.5, -0.2, 0.0}).position, -0.2, 1e-12);
  EXPECT_NEAR(tracking_error({{1, 1, 1.5}}, {1, 1, 1.0}).heading, 0.5, 1e-12);
}

TEST(Navigator, TimeRemainingIsThatOfTheSpeedOfNow) {
  EXPECT_NEAR(time_remaining(3.0, {0.5, 0.0}).to_seconds(), 6.0, 1e-9);
  EXPECT_EQ(time_remaining(3.0, {0.009, 0.0}), Duration{});
  EXPECT_EQ(time_remaining(0.09, {0.5, 0.0}), Duration{});
}

}  // namespace
}  // namespace bw
