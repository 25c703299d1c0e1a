#include "components/model/footprint_touch.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "components/model/differential_drive.hpp"
#include "components/model/footprint_distance.hpp"
#include "components/model/footprint_outline.hpp"
#include "components/model/random.hpp"

namespace bw {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
const std::vector<Vector2> kRectangle = {{0.255, 0.215}, {-0.255, 0.215}, {-0.255, -0.215}, {0.255, -0.215}};

double distance(const Twist2& twist, const Vector2& point) {
  return first_touch(twist, kRectangle, point).distance;
}

TEST(FirstTouch, StraightAheadIsTheDistanceToTheFront) {
  EXPECT_DOUBLE_EQ(distance({1.0, 0.0}, {2.0, 0.2}), 1.745);
  EXPECT_DOUBLE_EQ(distance({-1.0, 0.0}, {-2.0, 0.2}), 1.745);
  EXPECT_EQ(distance({1.0, 0.0}, {2.0, 0.22}), kNever);
  EXPECT_EQ(distance({1.0, 0.0}, {-2.0, 0.0}), kNever);
  EXPECT_EQ(distance({0.0, 0.0}, {0.0, 0.0}), kNever);
}

// Its side passes a wall at 0.25 m; rotating, the corner at 0.3335 m meets it 8.4 degrees on.
TEST(FirstTouch, ATurnOnTheSpotBringsTheCornerToTheWall) {
  const double corner = std::hypot(0.255, 0.215);
  const double touch = std::asin(0.25 / corner) - std::atan2(0.215, 0.255);
  const Vector2 point(std::sqrt(corner * corner - 0.25 * 0.25) - 1e-9, 0.25);
  const TouchOnArc found = first_touch({0.0, 0.5}, kRectangle, point);
  EXPECT_NEAR(found.distance, touch, 1e-6);
  EXPECT_NEAR(found.lever, corner, 1e-6);
  EXPECT_EQ(distance({0.0, 0.5}, {0.0, 0.34}), kNever);
}

TEST(FirstTouch, WhatIsInsideBlocksOnlyMotionsThatGoDeeper) {
  EXPECT_EQ(distance({0.2, 0.0}, {0.25, 0.0}), 0.0);
  EXPECT_EQ(distance({-0.2, 0.0}, {0.25, 0.0}), kNever);
  EXPECT_EQ(distance({0.2, 0.0}, {-0.25, 0.0}), kNever);
  // Beside its middle: rotating in place moves neither side away, ahead of it the left side comes nearer by
  // rotating left.
  EXPECT_EQ(distance({0.0, 0.5}, {0.1, 0.21}), 0.0);
  EXPECT_EQ(distance({0.0, -0.5}, {0.1, 0.21}), kNever);
}

/// First touch by brute force: steps in which no corner moves more than 0.5 mm.
double walked(const Twist2& twist, const Footprint& footprint, const Vector2& point, double most) {
  const double fastest = std::abs(twist.v) + std::abs(twist.omega) * footprint.radius;
  const double dt = 5e-4 / fastest;
  const double pace = twist.v != 0.0 ? std::abs(twist.v) : std::abs(twist.omega);
  for (double t = 0.0; t * pace <= most; t += dt)
    if (gap_to(footprint, advance_exact({}, twist, t), {point, point, 0.0}) < 0.0) return t * pace;
  return kNever;
}

TEST(FirstTouch, EqualsBruteForceOnRandomArcs) {
  Random random(311);
  int touches = 0;
  for (int i = 0; i < 1600; ++i) {
    std::vector<Vector2> corners;
    const int count = 3 + i % 6;
    for (int k = 0; k < count; ++k)
      corners.push_back(random.uniform(0.25, 0.5) *
                        direction(2.0 * std::numbers::pi * (k + random.uniform(-0.2, 0.2)) / count));
    const FootprintResult made = footprint_of(corners);
    if (!made.fault.empty()) continue;
    const double v = i % 5 == 0 ? 0.0 : (i % 2 == 0 ? 1.0 : -1.0) * random.uniform(0.05, 1.0);
    const double omega = i % 7 == 1 ? 0.0 : (i % 3 == 0 ? 1.0 : -1.0) * random.uniform(0.1, 2.0);
    const Vector2 point(random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2));
    const double gap = gap_to(made.footprint, {}, {point, point, 0.0});
    if (gap < 2e-3) continue;  // what is inside is told in the test above
    const double most = v == 0.0       ? 2.0 * std::numbers::pi
                        : omega == 0.0 ? 3.0
                                       : std::min(3.0, 2.0 * std::numbers::pi * std::abs(v / omega));
    const double exact = first_touch({v, omega}, made.footprint.polygon, point).distance;
    const double found = walked({v, omega}, made.footprint, point, most);
    // A step of 0.5 mm of the fastest corner is 0.5 mm of distance at most, and a graze shallower than it can
    // be overlooked.
    if (std::isfinite(found)) {
      EXPECT_NEAR(exact, found, 2e-2) << "case " << i;
      EXPECT_LE(exact, found + 1e-9) << "case " << i;
      ++touches;
    } else if (exact < most - 1e-6) {
      const Pose2 X = advance_exact({}, {v, omega}, exact / (v != 0.0 ? std::abs(v) : std::abs(omega)));
      EXPECT_NEAR(gap_to(made.footprint, X, {point, point, 0.0}), 0.0, 1e-9) << "case " << i;
    }
  }
  EXPECT_GT(touches, 150);
}

}  // namespace
}  // namespace bw
