// Closed forms of arcs that touch discs and walls.
#include "components/local_planner/dwa/arc.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "components/local_planner/dwa/stopping_motion.hpp"
#include "components/model/random.hpp"

namespace bw::dwa {
namespace {

constexpr double kRobot = 0.3;
constexpr double kFar = 20.0;

ClearanceField field_of(const StaticObstacles& obstacles) {
  return ClearanceField(obstacles, {}, {0.0, 0.0}, kRobot, kFar);
}

TEST(ContactDistance, StraightAtADisc) {
  // Centres 3 m apart along and 0.5 m across; contact at 0.3 + 0.4 + 0.1: 3 - sqrt(0.8^2 - 0.5^2).
  const ClearanceField field = field_of({.discs = {{{3.0, 0.5}, 0.4}}});
  const Arc straight{{}, {1.0, 0.0}};
  EXPECT_NEAR(contact_distance(straight, field, 0.1, 10.0), 3.0 - std::sqrt(0.39), 1e-4);
  EXPECT_TRUE(std::isinf(contact_distance(straight, field, 0.1, 2.0))) << "beyond the travel asked for";
}

TEST(ContactDistance, OnACircleAtADisc) {
  // Radius 2 m about (0, 2); a disc of 0.2 m on the circle at a quarter turn, (2, 2). Contact when the chord
  // is 0.5 m: quarter turn less 2 asin(0.25 / 2) of angle, times 2 m.
  const ClearanceField field = field_of({.discs = {{{2.0, 2.0}, 0.2}}});
  const double expected = 2.0 * (std::numbers::pi / 2.0 - 2.0 * std::asin(0.125));
  EXPECT_NEAR(contact_distance({{}, {1.0, 0.5}}, field, 0.0, 10.0), expected, 1e-4);
  EXPECT_NEAR(contact_distance({{}, {0.4, 0.2}}, field, 0.0, 10.0), expected, 1e-4)
      << "an arc has one contact, however fast it is driven";
}

TEST(ContactDistance, AtAWall) {
  // Wall across at 2 m: straight at 1.7 m. Towards it at 30 degrees: (2 - 0.3) / cos(30 deg).
  const ClearanceField field = field_of({.segments = {{{2.0, -9.0}, {2.0, 9.0}}}});
  EXPECT_NEAR(contact_distance({{}, {1.0, 0.0}}, field, 0.0, 5.0), 1.7, 1e-4);
  EXPECT_NEAR(contact_distance({{0.0, 0.0, std::numbers::pi / 6.0}, {1.0, 0.0}}, field, 0.0, 5.0),
              1.7 / std::cos(std::numbers::pi / 6.0), 1e-4);
}

TEST(ContactDistance, NoneForPassingParallelStandingOrFree) {
  const ClearanceField wall = field_of({.segments = {{{-9.0, 0.5}, {9.0, 0.5}}}});
  EXPECT_TRUE(std::isinf(contact_distance({{}, {1.0, 0.0}}, wall, 0.1, 5.0)));
  EXPECT_TRUE(std::isinf(contact_distance({{}, {0.0, 1.0}}, wall, 0.1, 5.0)));
  EXPECT_TRUE(std::isinf(contact_distance({{}, {1.0, 0.2}}, field_of({}), 0.1, 5.0)));
}

TEST(ContactDistance, ZeroInsideTheMargin) {
  const ClearanceField field = field_of({.points = {{0.35, 0.0}}});
  EXPECT_EQ(contact_distance({{}, {1.0, 0.0}}, field, 0.1, 5.0), 0.0);
}

TEST(SmallestGap, OfAStraightArcPastADisc) {
  const ClearanceField field = field_of({.discs = {{{2.0, 1.5}, 0.3}}});
  EXPECT_NEAR(smallest_gap({{}, {1.0, 0.0}}, field, 3.0, 0.1), 0.9, 2e-3) << "1.5 - 0.3 - 0.3 at 2 m";
  EXPECT_NEAR(smallest_gap({{}, {1.0, 0.0}}, field, 1.0, 0.1), std::hypot(1.0, 1.5) - 0.6, 1e-12)
      << "at the end of 1 m";
}

TEST(SmallestGap, OfPredictedMoversIsWhereTheyWillBe) {
  // Crosses the robot's line 2 m ahead, 2 s later; the robot is there after 2 s: centres coincide.
  Mover mover;
  mover.position = {2.0, -2.0};
  mover.velocity = {0.0, 1.0};
  EXPECT_NEAR(smallest_gap({{}, {1.0, 0.0}}, {mover}, kRobot, 3.0, 0.1), -0.6, 1e-9);
}

TEST(StoppingMotion, HoldsThenBrakesOnTheSameCurve) {
  // 0.8 m/s held for 0.1 s and braked with 1 m/s^2: 0.08 + 0.32 m in 0.1 + 0.8 s, on a circle of 2 m radius.
  const Arc arc{{}, {0.8, 0.4}};
  const std::vector<TrajectoryPoint> motion = stopping_motion(arc, 0.1, 1.0);
  EXPECT_NEAR(motion.back().time, 0.9, 1e-9);
  EXPECT_EQ(motion.back().twist, Twist2{});
  EXPECT_NEAR(motion.back().pose.theta, 0.4 / 2.0, 1e-9);
  for (const TrajectoryPoint& point : motion) {
    EXPECT_NEAR((point.pose.position() - Vector2(0.0, 2.0)).norm(), 2.0, 1e-9);
    EXPECT_NEAR(point.twist.omega, 0.5 * point.twist.v, 1e-12);
  }
  EXPECT_EQ(stopping_motion({{}, {0.0, 0.5}}, 0.1, 1.0).size(), 2U) << "turning on the spot needs no way";
  EXPECT_LE(stopping_motion({{}, {1e3, 0.5}}, 0.1, 1e-6).size(), 110U) << "braking for 1e9 s is 100 steps";
}

TEST(ContactDistance, EndsOnEndlessWays) {
  // 1e6 m along a wall 1 mm beyond the margin: 1000 looks 5 mm apart, then it is no longer called free.
  StaticObstacles wall;
  wall.segments.push_back({{-1e6, 0.401}, {1e6, 0.401}});  // robot radius 0.3, margin 0.1
  EXPECT_NEAR(contact_distance({{}, {1.0, 0.0}}, field_of(wall), 0.1, 1e6), 5.0, 1e-6);
  // A circle of 1 m radius past a point inside: free for one turn is free for a million.
  StaticObstacles middle;
  middle.points.push_back({0.0, 1.0});
  EXPECT_EQ(contact_distance({{}, {1.0, 1.0}}, field_of(middle), 0.1, 1e6), INFINITY);
}

TEST(ArcSearches, AgreeWithFineSampling) {
  Random random(5);
  for (int scene = 0; scene < 300; ++scene) {
    StaticObstacles obstacles;
    for (int i = 0; i < 4; ++i) {
      obstacles.points.push_back({random.uniform(-3, 3), random.uniform(-3, 3)});
      obstacles.discs.push_back({{random.uniform(-4, 4), random.uniform(-4, 4)}, random.uniform(0.0, 0.5)});
      obstacles.segments.push_back(
          {{random.uniform(-4, 4), random.uniform(-4, 4)}, {random.uniform(-4, 4), random.uniform(-4, 4)}});
    }
    const ClearanceField field = field_of(obstacles);
    const Arc arc{{0.0, 0.0, random.uniform(-3, 3)}, {random.uniform(0.1, 1.0), random.uniform(-1, 1)}};
    const double margin = 0.1;
    double smallest = field.at({0.0, 0.0});
    double contact = smallest <= margin ? 0.0 : INFINITY;
    for (int i = 1; i <= 3000; ++i) {
      const double gap = field.at(arc.at(0.001 * i).position());
      smallest = std::min(smallest, gap);
      if (gap <= margin) contact = std::min(contact, 0.001 * i * arc.twist.v);
    }
    EXPECT_NEAR(smallest_gap(arc, field, 3.0, 0.1), smallest, 0.051 * arc.twist.v) << scene;
    const double found = contact_distance(arc, field, margin, 3.0 * arc.twist.v);
    // A graze shorter than the shortest march (5 mm) may be missed: less than 0.02 mm deep.
    if (std::isfinite(contact) && std::isfinite(found)) {
      EXPECT_NEAR(found, contact, 0.002) << scene;
    } else if (std::isfinite(contact)) {
      EXPECT_GT(smallest, margin - 1e-4) << scene;
    }
  }
}

}  // namespace
}  // namespace bw::dwa
