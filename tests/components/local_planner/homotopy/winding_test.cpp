#include "components/local_planner/homotopy/winding.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/components/local_planner/homotopy/scenes.hpp"

namespace bw::homotopy {
namespace {

constexpr double kPi = std::numbers::pi;

Route route(const std::vector<Vector2>& points) { return route_at_speed(points, 1.0); }

TEST(Winding, SidesOfOneDiscDifferByAFullTurn) {
  // A body on the line is seen at bearing pi from the start and 0 from the goal: half a turn on either side.
  const std::vector<Body> bodies{standing({5.0, 0.0}, 0.3)};
  const Course course = ten_metres();
  const auto left = winding(route({{0, 0}, {5, 1}, {10, 0}}), bodies, course);
  const auto right = winding(route({{0, 0}, {5, -1}, {10, 0}}), bodies, course);
  EXPECT_NEAR(left[0], -kPi, 1e-12);
  EXPECT_NEAR(right[0], kPi, 1e-12);
  EXPECT_EQ(windings_between(right, left), std::vector<int>{1});
  EXPECT_FALSE(same_winding(left, right));
}

TEST(Winding, ARoundTripAddsATurn) {
  const std::vector<Body> bodies{standing({5.0, 0.0}, 0.3)};
  const auto once = winding(route({{0, 0}, {5, -1}, {10, 0}}), bodies, ten_metres());
  const auto twice =
      winding(route({{0, 0}, {5, -1}, {6, 0}, {5, 1}, {4, 0}, {5, -1}, {10, 0}}), bodies, ten_metres());
  EXPECT_NEAR(twice[0] - once[0], 2.0 * kPi, 1e-12);
}

TEST(Winding, IsTheSumOfWrappedBearingDifferences) {
  // homotopy/theory.md 6.2: W_l = sum of wrap(arg(z2 - c_l) - arg(z1 - c_l)).
  Random random(1);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Vector2> points{{0.0, 0.0}};
    for (int k = 0; k < 8; ++k) points.push_back({random.uniform(-1, 11), random.uniform(-3, 3)});
    points.push_back({10.0, 0.0});
    std::vector<Body> bodies;
    for (const Vector2& p : separated(random, 5, 0.5)) bodies.push_back(standing(p, 0.1));
    const auto angles = winding(route(points), bodies, ten_metres());
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      double expected = 0.0;
      for (std::size_t k = 1; k < points.size(); ++k) {
        const Vector2 u = points[k - 1] - bodies[b].representative;
        const Vector2 v = points[k] - bodies[b].representative;
        expected += wrap_angle(std::atan2(v.y(), v.x()) - std::atan2(u.y(), u.x()));
      }
      EXPECT_NEAR(angles[b], expected, 1e-9);
    }
  }
}

TEST(Winding, FlipsItsSignInTheMirror) {
  Random random(2);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Vector2> points{{0.0, 0.0}};
    for (int k = 0; k < 5; ++k) points.push_back({random.uniform(0, 10), random.uniform(-3, 3)});
    std::vector<Body> bodies;
    for (const Vector2& p : separated(random, 4, 0.5)) bodies.push_back(standing(p, 0.1));
    std::vector<Vector2> mirrored_points;
    for (const Vector2& p : points) mirrored_points.push_back({p.x(), -p.y()});
    std::vector<Body> mirrored_bodies;
    for (const Body& b : bodies) {
      mirrored_bodies.push_back(standing({b.representative.x(), -b.representative.y()}, 0.1));
    }
    const auto angles = winding(route(points), bodies, ten_metres());
    const auto mirrored = winding(route(mirrored_points), mirrored_bodies, ten_metres());
    for (std::size_t b = 0; b < bodies.size(); ++b) EXPECT_NEAR(mirrored[b], -angles[b], 1e-9);
  }
}

TEST(Winding, JoinsRoutesToTheCourse) {
  // A band of the last cycle begins behind the robot and ends beside a goal that moved: still one class.
  const std::vector<Body> bodies{standing({5.0, 0.0}, 0.3), standing({7.0, 1.0}, 0.3)};
  const auto now = winding(route({{0, 0}, {5, 1}, {10, 0}}), bodies, ten_metres());
  const auto before = winding(route({{-0.2, 0.1}, {5, 0.9}, {9.8, -0.1}}), bodies, ten_metres());
  for (std::size_t b = 0; b < bodies.size(); ++b) EXPECT_NEAR(now[b], before[b], 1e-12);
}

TEST(Winding, ExactlyThroughABodyCountsAsRightOfIt) {
  const std::vector<Body> bodies{standing({5.0, 0.0}, 0.3)};
  EXPECT_NEAR(winding(route({{0, 0}, {10, 0}}), bodies, ten_metres())[0], kPi, 1e-12);
  Course back = ten_metres();
  std::swap(back.start, back.goal);
  EXPECT_NEAR(winding(route({{10, 0}, {0, 0}}), bodies, back)[0], kPi, 1e-12);
  for (const Vector2& goal : {Vector2(6, 8), Vector2(-6, 8), Vector2(6, -8), Vector2(-6, -8)}) {
    const Course slanted{{0.0, 0.0}, goal, 0.3, 0.2, 1.0};
    EXPECT_NEAR(winding(route({{0, 0}, goal}), {standing(0.5 * goal, 0.3)}, slanted)[0], kPi, 1e-12);
  }
}

TEST(Winding, TellsPassingBeforeAMoverFromPassingBehindIt) {
  // Somebody walks up across the line at x = 5 and is on it after 4 s. The same path at 2 m/s is there after
  // 2.5 s, in front; at 1 m/s after 5 s, behind.
  Body walker = standing({5.0, 0.0}, 0.3);
  walker.motion = mover_at({5.0, -4.0}, {0.0, 1.0});
  for (const bool predicted : {false, true}) {
    if (predicted) walker.motion->predictions = {{2.0, {5.0, -2.0}}, {8.0, {5.0, 4.0}}};
    const auto before = winding(route_at_speed({{0, 0}, {10, 0}}, 2.0), {walker}, ten_metres());
    const auto behind = winding(route_at_speed({{0, 0}, {10, 0}}, 1.0), {walker}, ten_metres());
    EXPECT_EQ(windings_between(behind, before), std::vector<int>{1});  // in front of it: on its left
    const auto even_slower = winding(route_at_speed({{0, 0}, {10, 0}}, 0.6), {walker}, ten_metres());
    EXPECT_TRUE(same_winding(behind, even_slower));
  }
}

TEST(Winding, NamesClassesByTheBodiesTheyDisagreeAbout) {
  // The body far on the left is passed on the right by all.
  const std::vector<Body> bodies{standing({3.0, 0.0}, 0.3), standing({5.0, 4.0}, 0.3),
                                 standing({7.0, 0.0}, 0.3)};
  std::vector<std::vector<double>> angles;
  for (const double a : {1.0, -1.0}) {
    for (const double b : {1.0, -1.0}) {
      angles.push_back(winding(route({{0, 0}, {3, a}, {7, b}, {10, 0}}), bodies, ten_metres()));
    }
  }
  EXPECT_EQ(class_labels(angles), (std::vector<std::string>{"LL", "LR", "RL", "RR"}));
  EXPECT_EQ(class_labels({angles[0]}), std::vector<std::string>{"-"});
  EXPECT_TRUE(class_labels({}).empty());
}

TEST(Winding, IsFiniteForDegenerateRoutes) {
  const std::vector<Body> bodies{standing({0.0, 0.0}, 0.3)};
  for (const Route& r : {Route{}, route({{0, 0}}), route({{0, 0}, {0, 0}, {0, 0}})}) {
    EXPECT_TRUE(std::isfinite(winding(r, bodies, ten_metres())[0]));
  }
}

}  // namespace
}  // namespace bw::homotopy
