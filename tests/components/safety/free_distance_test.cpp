#include "components/safety/free_distance.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "components/model/differential_drive.hpp"
#include "components/model/random.hpp"

namespace bw::safety {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

TEST(FreeDistance, StraightAheadIsTheDistanceLessTheChord) {
  EXPECT_DOUBLE_EQ(free_distance({1.0, 0.0}, 0.3, {2.0, 0.0}), 1.7);
  EXPECT_NEAR(free_distance({0.5, 0.0}, 0.5, {2.0, 0.3}), 2.0 - 0.4, 1e-12);  // 0.3-0.4-0.5 triangle
  EXPECT_EQ(free_distance({1.0, 0.0}, 0.3, {2.0, 0.31}), kNever);
  EXPECT_EQ(free_distance({1.0, 0.0}, 0.3, {-2.0, 0.0}), kNever);
  EXPECT_DOUBLE_EQ(free_distance({-1.0, 0.0}, 0.3, {-2.0, 0.0}), 1.7);
}

TEST(FreeDistance, AQuarterTurnLeftReachesAPointOnTheCircle) {
  // rho = 2: the point (2, 2) lies on the circle at phi = 90 deg; cos(alpha) = 1 - 0.3^2 / (2 * 2^2)
  const double expected = 2.0 * (std::numbers::pi / 2.0 - std::acos(1.0 - 0.09 / 8.0));
  EXPECT_NEAR(free_distance({1.0, 0.5}, 0.3, {2.0, 2.0}), expected, 1e-12);
  EXPECT_NEAR(free_distance({1.0, -0.5}, 0.3, {2.0, -2.0}), expected, 1e-12);
  EXPECT_NEAR(free_distance({-1.0, -0.5}, 0.3, {-2.0, 2.0}), expected, 1e-12);
}

TEST(FreeDistance, ATurnOnTheSpotTouchesNothing) {
  EXPECT_EQ(free_distance({0.0, 1.0}, 0.3, {0.31, 0.0}), kNever);
}

TEST(FreeDistance, WhatIsTooNearBlocksOnlyMotionsTowardsIt) {
  EXPECT_EQ(free_distance({0.2, 0.1}, 0.3, {0.25, 0.1}), 0.0);
  EXPECT_EQ(free_distance({-0.2, 0.1}, 0.3, {0.25, 0.1}), kNever);
  EXPECT_EQ(free_distance({-0.2, 0.0}, 0.3, {-0.25, 0.1}), 0.0);
}

/// First touch by brute force: steps of 0.2 mm along the arc.
double walked(const Twist2& twist, double radius, const Vector2& point, double most) {
  constexpr double kStep = 2e-4;
  const double dt = kStep / std::abs(twist.v);
  Pose2 X;
  for (double distance = 0.0; distance <= most; distance += kStep) {
    if ((point - X.position()).norm() < radius) return distance;
    X = advance_exact(X, twist, dt);
  }
  return kNever;
}

TEST(FreeDistance, EqualsBruteForceOnRandomArcs) {
  Random random(71);
  int touches = 0;
  for (int i = 0; i < 3000; ++i) {
    const double v = (i % 2 == 0 ? 1.0 : -1.0) * random.uniform(0.05, 1.0);
    const double omega = i % 7 == 0 ? 0.0 : random.uniform(-2.0, 2.0);
    const double radius = random.uniform(0.1, 0.5);
    const Vector2 point(random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5));
    if (point.norm() < radius) continue;
    const double distance = free_distance({v, omega}, radius, point);
    // The whole circle, or 3 m of a flatter arc.
    const double most = omega == 0.0 ? 3.0 : std::min(3.0, 2.0 * std::numbers::pi * std::abs(v / omega));
    const double expected = walked({v, omega}, radius, point, most);
    if (distance >= most) {
      EXPECT_GE(expected, most - 1e-3) << i;
      continue;
    }
    if (std::isinf(expected)) {  // it grazes the point by less than a step sees
      EXPECT_GE(free_distance({v, omega}, radius - 1e-6, point), most);
      continue;
    }
    ++touches;
    EXPECT_NEAR(distance, expected, 3e-4) << i;
  }
  EXPECT_GT(touches, 300);
}

TEST(FreeDistanceToWalker, CountsFromTheFrontOfTheDiscOnceThePointIsInTheWay) {
  EXPECT_DOUBLE_EQ(free_distance_to_walker({1.0, 0.0}, 0.5, {2.0, 0.45}), 1.5);
  EXPECT_NEAR(free_distance_to_walker({1.0, 0.0}, 0.5, {0.55, 0.3}), 0.05, 1e-12);
  EXPECT_EQ(free_distance_to_walker({1.0, 0.0}, 0.5, {2.0, 0.51}), kNever);
  EXPECT_DOUBLE_EQ(free_distance_to_walker({-1.0, 0.0}, 0.5, {-2.0, 0.45}), 1.5);
  // rho = 2, at (2.3, 2): abreast after a quarter turn
  EXPECT_NEAR(free_distance_to_walker({1.0, 0.5}, 0.5, {2.3, 2.0}), std::numbers::pi - 0.5, 1e-12);
}

TEST(SpeedWithin, SolvesTheStoppingDistance) {
  const Stopping stopping{.reaction_time = 0.25, .deceleration = 2.0};
  EXPECT_NEAR(speed_within(0.5, stopping), 1.0, 1e-12);  // 1.0 * 0.25 + 1 / 4: table of the research, 1.0 m/s
  EXPECT_NEAR(speed_within(0.75, {0.25, 1.0}), 1.0, 1e-12);
  EXPECT_EQ(speed_within(0.0, stopping), 0.0);
  EXPECT_EQ(speed_within(-1.0, stopping), 0.0);
  EXPECT_EQ(speed_within(kNever, stopping), kNever);
}

TEST(SpeedWithin, LeavesTheEndSpeedAndCountsAnApproach) {
  // v t + (v^2 - w^2) / 2a = 0.1 + (1 - 0.04) / 4
  EXPECT_NEAR(speed_within(0.34, {0.1, 2.0}, 0.2), 1.0, 1e-12);
  EXPECT_EQ(speed_within(-0.1, {0.1, 2.0}, 0.2), 0.2);
  // 0.5 * 0.1 + 0.25 / 4 + 1.6 (0.1 + 0.25) = 0.6725
  EXPECT_NEAR(speed_within(0.6725, {0.1, 2.0, 1.6}), 0.5, 1e-12);
}

}  // namespace
}  // namespace bw::safety
