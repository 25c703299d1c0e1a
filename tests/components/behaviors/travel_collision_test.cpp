// Motions among things and people: they end before a contact, and say so. The robot's disc has 0.3 m; at 0.5
// m/s it stops within 0.125 m and what the jerk limit of 5 m/s^3 adds, 0.05 m.
#include <gmock/gmock.h>

#include "tests/components/behaviors/behavior_drive.hpp"

namespace bw {
namespace {

using State = BehaviorStep::State;

void drive(BehaviorDrive& d, double x, double speed, bool disable_checks = false) {
  d.run(
      *make_drive_on_heading({.target = {x, 0.0}, .speed = speed, .disable_collision_checks = disable_checks},
                             d.options, d.robot.limits, BehaviorDrive::begin()));
}
void back_up(BehaviorDrive& d, double x, double speed) {
  d.run(
      *make_back_up({.target = {x, 0.0}, .speed = speed}, d.options, d.robot.limits, BehaviorDrive::begin()));
}
Mover walker(Vector2 position, Vector2 velocity) {
  Mover mover;
  mover.position = position;
  mover.velocity = velocity;
  return mover;
}

TEST(TravelCollision, StopsBeforeWhatStandsInTheWay) {
  for (const double speed : {0.1, 0.5, 1.0}) {
    BehaviorDrive d;
    d.obstacles.points = {{2.0, 0.1}};
    drive(d, 3.0, speed);
    EXPECT_EQ(d.last.state, State::failed) << speed;
    EXPECT_EQ(d.last.error, BehaviorError::collision_ahead);
    EXPECT_EQ(d.last.text, "something is in the way");
    EXPECT_EQ(d.commands.back(), Twist2{});
    EXPECT_GT(d.least_gap, 0.0);
    // The contact is seen 2 s ahead: it may have driven up to there.
    EXPECT_GT(d.pose.x, 1.7 - 2.0 * speed - 0.15) << speed;
  }
}

TEST(TravelCollision, AWallBeyondTheTargetIsNoneOfItsBusiness) {
  BehaviorDrive d;
  d.obstacles.points = {{1.35, 0.0}};  // 0.05 m from where the robot ends
  drive(d, 1.0, 1.0);
  EXPECT_EQ(d.last.state, State::succeeded) << d.last.text;
  EXPECT_NEAR(d.least_gap, 0.05, 0.01);
}

TEST(TravelCollision, ALookAheadOfZeroStillLeavesRoomToStop) {
  BehaviorDrive d;
  d.options.simulate_ahead_time = 0.0;
  d.obstacles.points = {{2.0, 0.0}};
  drive(d, 3.0, 1.0);
  EXPECT_EQ(d.last.error, BehaviorError::collision_ahead);
  EXPECT_GT(d.least_gap, 0.0);
}

TEST(TravelCollision, SomebodyWhoWalksIntoTheWayEndsIt) {
  // At y = 0 after 2 s, when the robot is 1 m along: they meet at (1, 0).
  BehaviorDrive d;
  d.movers = {walker({1.0, -2.0}, {0.0, 1.0})};
  drive(d, 2.0, 0.5);
  EXPECT_EQ(d.last.error, BehaviorError::collision_ahead);
  EXPECT_GT(d.least_gap, 0.0);
  // Two seconds later nobody is there.
  BehaviorDrive late;
  late.movers = {walker({1.0, -6.0}, {0.0, 1.0})};
  drive(late, 2.0, 0.5);
  EXPECT_EQ(late.last.state, State::succeeded) << late.last.text;
}

TEST(TravelCollision, SomebodyWhoIsExpectedToTurnAwayEndsNothing) {
  BehaviorDrive d;
  Mover mover = walker({1.0, -1.0}, {0.0, 0.5});
  mover.predictions = {{.time = 0.2, .position = {1.0, -0.9}}, {.time = 10.0, .position = {5.0, -3.0}}};
  d.movers = {mover};
  d.spoil = [](double t, BehaviorSituation& s) {
    s.problem.movers[0].predictions[1].time = std::max(0.3, 10.0 - t);
  };
  drive(d, 0.3, 0.2);
  EXPECT_EQ(d.last.state, State::succeeded) << d.last.text;
}

TEST(TravelCollision, WhatIsTooNearBlocksOnlyMotionsTowardsIt) {
  // 5 cm inside of the disc, ahead: as a costmap shows it whose cells are coarse.
  for (const auto& position : {Vector2{0.25, 0.0}, Vector2{0.2, 0.15}}) {
    BehaviorDrive away;
    away.obstacles.points = {position};
    back_up(away, 0.3, 0.2);
    EXPECT_EQ(away.last.state, State::succeeded) << away.last.text;
    BehaviorDrive towards;
    towards.obstacles.points = {position};
    drive(towards, 0.3, 0.2);
    EXPECT_EQ(towards.last.error, BehaviorError::collision_ahead);
    EXPECT_NEAR(towards.pose.x, 0.0, 1e-9);
    // And what is behind counts as ever.
    BehaviorDrive between;
    between.obstacles.points = {position, {-0.45, 0.0}};
    back_up(between, 0.3, 0.2);
    EXPECT_EQ(between.last.error, BehaviorError::collision_ahead);
  }
}

// They walk at 1 m/s against a robot that backs away with 0.2 m/s: standing is no better.
TEST(TravelCollision, WhoWalksAgainstTheRobotBlocksNoMotionThatLeadsAway) {
  BehaviorDrive away;
  away.movers = {walker({2.0, 0.0}, {-1.0, 0.0})};
  back_up(away, 0.3, 0.2);
  EXPECT_EQ(away.last.state, State::succeeded) << away.last.text;
  BehaviorDrive towards;
  towards.movers = {walker({2.0, 0.0}, {-1.0, 0.0})};
  drive(towards, 0.3, 0.2);
  EXPECT_EQ(towards.last.error, BehaviorError::collision_ahead);
}

// A disc that rotates goes nowhere; a box of 0.5 x 0.2 m sweeps a disc of 0.54 m, and a post stands at 0.4 m
// to its side.
TEST(TravelCollision, SpinLooksAtTheOutline) {
  const auto spin = [](BehaviorDrive& d) {
    d.run(*make_spin({.target_yaw = 1.57}, d.options, BehaviorDrive::begin()));
  };
  BehaviorDrive disc;
  disc.obstacles.points = {{0.0, 0.31}};
  disc.movers = {walker({1.0, 0.0}, {-0.5, 0.0})};
  spin(disc);
  EXPECT_EQ(disc.last.state, State::succeeded) << disc.last.text;
  BehaviorDrive box;
  box.obstacles.points = {{0.0, 0.4}};
  box.spoil = [](double, BehaviorSituation& s) {
    s.problem.footprint = {0.54, {{0.5, 0.2}, {-0.5, 0.2}, {-0.5, -0.2}, {0.5, -0.2}}};
  };
  spin(box);
  EXPECT_EQ(box.last.error, BehaviorError::collision_ahead);
  // The corner at atan(0.2 / 0.5) = 0.38 rad, 0.539 m away, meets y = 0.4 at x = 0 when it has rotated by
  // about pi/2 - 0.38 = 1.19 rad less what its front edge leads: before that it stops.
  EXPECT_LT(box.rotated, 1.0);
}

TEST(TravelCollision, ChecksThatAreDisabledAreDisabled) {
  BehaviorDrive d;
  d.obstacles.points = {{0.5, 0.0}};
  drive(d, 0.4, 0.3, true);
  EXPECT_EQ(d.last.state, State::succeeded);
  EXPECT_LT(d.least_gap, 0.0);
}

}  // namespace
}  // namespace bw
