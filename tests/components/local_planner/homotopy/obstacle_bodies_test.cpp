#include "components/local_planner/homotopy/obstacle_bodies.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/components/local_planner/homotopy/scenes.hpp"

namespace bw::homotopy {
namespace {

// Keypoints keep half the wanted gap: 2 (0.3 + 0.5 * 0.2) = 0.8 m is the widest gap that is closed.
constexpr double kWidestGap = 0.8;

std::vector<Body> bodies_among(const StaticObstacles& statics, const HomotopyOptions& options = {}) {
  return bodies_of(statics, {}, ten_metres(), options);
}

std::vector<Body> bodies_among(const std::vector<Mover>& movers, const HomotopyOptions& options = {}) {
  return bodies_of({}, movers, ten_metres(), options);
}

TEST(ObstacleBodies, RowsOfPointsAreOneBodyWhereTheRobotDoesNotFit) {
  for (const bool across : {false, true}) {
    for (const double spacing : {kWidestGap - 1e-6, kWidestGap + 1e-6}) {
      StaticObstacles row;
      for (int k = 0; k < 6; ++k) {
        row.points.push_back(across ? Vector2(5.0, -2.0 + k * spacing) : Vector2(2.0 + k * spacing, 0.5));
      }
      const std::size_t expected = spacing < kWidestGap ? 1 : 6;
      EXPECT_EQ(bodies_among(row).size(), expected) << across << spacing;
    }
  }
}

TEST(ObstacleBodies, GapsAreMeasuredBetweenBoundaries) {
  // Disc of 0.5 m, a segment that ends and a point 0.79 or 0.81 m beside it.
  for (const double gap : {0.79, 0.81}) {
    StaticObstacles obstacles;
    obstacles.discs = {{{5.0, 0.0}, 0.5}};
    obstacles.segments = {{{5.5 + gap, 0.0}, {7.5, 0.0}}};
    obstacles.points = {{4.5 - gap, 0.0}};
    const std::vector<Body> bodies = bodies_among(obstacles);
    ASSERT_EQ(bodies.size(), gap < kWidestGap ? 1u : 3u);
    if (gap < kWidestGap) {
      EXPECT_EQ(bodies[0].parts.size(), 3u);
    }
  }
}

TEST(ObstacleBodies, TheRandomRoadmapClosesWiderGaps) {
  // It keeps all of the wanted gap: 2 (0.3 + 0.2) = 1.
  StaticObstacles pair;
  pair.points = {{5.0, -0.45}, {5.0, 0.45}};
  EXPECT_EQ(bodies_among(pair).size(), 2u);
  HomotopyOptions options;
  options.method = Vertices::roadmap;
  EXPECT_EQ(bodies_among(pair, options).size(), 1u);
}

TEST(ObstacleBodies, ClustersMatchBruteForce) {
  Random random(4);
  for (int trial = 0; trial < 60; ++trial) {
    StaticObstacles obstacles;
    const double gap = random.uniform(0.0, 1.0);
    const int count = 1 + static_cast<int>(random.uniform(0.0, 120.0));
    for (int k = 0; k < count; ++k) {
      obstacles.points.push_back({random.uniform(-5, 5), random.uniform(-5, 5)});
    }
    // Components by repeated flooding.
    const std::vector<Vector2>& points = obstacles.points;
    std::vector<int> colour(points.size(), -1);
    int colours = 0;
    for (std::size_t seed = 0; seed < points.size(); ++seed) {
      if (colour[seed] >= 0) continue;
      std::vector<std::size_t> stack{seed};
      colour[seed] = colours;
      while (!stack.empty()) {
        const std::size_t i = stack.back();
        stack.pop_back();
        for (std::size_t k = 0; k < points.size(); ++k) {
          if (colour[k] >= 0 || (points[k] - points[i]).norm() > gap) continue;
          colour[k] = colours;
          stack.push_back(k);
        }
      }
      ++colours;
    }
    EXPECT_EQ(clusters_of(obstacles, gap).size(), static_cast<std::size_t>(colours)) << "gap " << gap;
  }
}

TEST(ObstacleBodies, OnlyWhatLiesBetweenStartAndGoalMatters) {
  // The strip is 6 m wide and 10 m long; discs reach 0.2 m.
  StaticObstacles obstacles;
  obstacles.discs = {{{-0.3, 0.0}, 0.2}, {{10.3, 0.0}, 0.2}, {{5.0, 3.3}, 0.2}, {{5.0, -3.3}, 0.2}};
  EXPECT_TRUE(bodies_among(obstacles).empty());
  obstacles.discs = {{{-0.1, 2.0}, 0.2}, {{10.1, -2.0}, 0.2}, {{5.0, 3.1}, 0.2}};
  EXPECT_EQ(bodies_among(obstacles).size(), 3u);
}

TEST(ObstacleBodies, ComeInTheOrderInWhichTheyAreMetWhateverTheInput) {
  Random random(5);
  for (int trial = 0; trial < 50; ++trial) {
    StaticObstacles obstacles;
    for (int k = 0; k < 30; ++k) {
      obstacles.points.push_back({random.uniform(0, 10), random.uniform(-3, 3)});
    }
    for (int k = 0; k < 5; ++k) {
      const Vector2 a{random.uniform(0, 10), random.uniform(-3, 3)};
      obstacles.segments.push_back({a, a + Vector2(random.uniform(-1, 1), random.uniform(-1, 1))});
    }
    const std::vector<Body> bodies = bodies_among(obstacles);
    StaticObstacles shuffled = obstacles;
    std::reverse(shuffled.points.begin(), shuffled.points.end());
    std::rotate(shuffled.points.begin(), shuffled.points.begin() + 7, shuffled.points.end());
    std::reverse(shuffled.segments.begin(), shuffled.segments.end());
    for (Segment& s : shuffled.segments) std::swap(s.a, s.b);
    const std::vector<Body> again = bodies_among(shuffled);
    ASSERT_EQ(bodies.size(), again.size());
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      EXPECT_EQ(bodies[b].representative, again[b].representative);
      EXPECT_EQ(bodies[b].parts.size(), again[b].parts.size());
      if (b > 0) {
        EXPECT_LE(bodies[b - 1].representative.x(), bodies[b].representative.x());
      }
    }
  }
}

TEST(ObstacleBodies, RepresentativesLieOnTheirBodies) {
  // The mean of an L lies off it.
  StaticObstacles corner;
  corner.segments = {{{4.0, 0.0}, {8.0, 0.0}}, {{4.0, 0.0}, {4.0, 2.5}}};
  const std::vector<Body> bodies = bodies_among(corner);
  ASSERT_EQ(bodies.size(), 1u);
  const Vector2& p = bodies[0].representative;
  EXPECT_TRUE(p == Vector2(6.0, 0.0) || p == Vector2(4.0, 1.25));
}

TEST(ObstacleBodies, AMoverIsWhereARobotThatHeadsForItMeetsIt) {
  // Up across x = 4 from y = -4.2 at 1 m/s: |(4, -4.2 + t)| = t for t = 33.64 / 8.4 = 4.005 s.
  const std::vector<Body> crossing = bodies_among(std::vector{mover_at({4.0, -4.2}, {0.0, 1.0})});
  ASSERT_EQ(crossing.size(), 1u);
  EXPECT_NEAR(crossing[0].representative.x(), 4.0, 1e-12);
  EXPECT_NEAR(crossing[0].representative.y(), 33.64 / 8.4 - 4.2, 0.05);
  // Head on from 8 m at 1 m/s: half way.
  const std::vector<Body> head_on = bodies_among(std::vector{mover_at({8.0, 0.0}, {-1.0, 0.0})});
  ASSERT_EQ(head_on.size(), 1u);
  EXPECT_NEAR(head_on[0].representative.x(), 4.0, 0.05);
  // Nobody catches up with somebody as fast.
  EXPECT_TRUE(bodies_among(std::vector{mover_at({2.0, 0.0}, {1.0, 0.0})}).empty());
}

TEST(ObstacleBodies, ACapsuleHoldsAMoverAndItsFuture) {
  HomotopyOptions options;
  options.mover_topology = MoverTopology::capsule;
  Mover mover = mover_at({4.0, -2.0}, {0.0, 1.0});
  std::vector<Body> bodies = bodies_among(std::vector{mover}, options);
  ASSERT_EQ(bodies.size(), 1u);
  EXPECT_FALSE(bodies[0].motion);
  ASSERT_EQ(bodies[0].parts.size(), 1u);
  EXPECT_EQ(bodies[0].parts[0].axis.a, Vector2(4.0, -2.0));
  EXPECT_NEAR(bodies[0].parts[0].axis.b.y(), -0.4, 1e-12);  // 1.6 s later
  EXPECT_NEAR(bodies[0].representative.y(), -1.2, 1e-12);
  // A predicted turn after 0.8 s is followed: corners every 0.4 s.
  mover.predictions = {{0.8, {4.0, -1.2}}, {1.6, {4.8, -1.2}}};
  bodies = bodies_among(std::vector{mover}, options);
  ASSERT_EQ(bodies[0].parts.size(), 4u);
  EXPECT_NEAR(bodies[0].parts[2].axis.a.y(), -1.2, 1e-12);
  EXPECT_NEAR(bodies[0].parts[3].axis.b.x(), 4.8, 1e-12);
  options.mover_topology = MoverTopology::present;
  bodies = bodies_among(std::vector{mover}, options);
  EXPECT_EQ(bodies[0].representative, Vector2(4.0, -2.0));
}

TEST(ObstacleBodies, TheCapKeepsMoversAndTheNearest) {
  StaticObstacles obstacles;
  for (int k = 0; k < 9; ++k) obstacles.points.push_back({1.0 + k, 0.3 * k});
  HomotopyOptions options;
  options.max_bodies = 4;
  options.mover_topology = MoverTopology::present;
  const std::vector<Body> bodies =
      bodies_of(obstacles, {mover_at({5.0, 2.9}, {0.0, 0.0})}, ten_metres(), options);
  ASSERT_EQ(bodies.size(), 4u);
  EXPECT_TRUE(
      std::any_of(bodies.begin(), bodies.end(), [](const Body& b) { return b.mover_id.has_value(); }));
  for (const Body& b : bodies) {
    if (!b.mover_id) {
      EXPECT_LT(b.representative.x(), 3.5);
    }
  }
}

TEST(ObstacleBodies, DegenerateInputIsHarmless) {
  StaticObstacles heap;
  for (int k = 0; k < 1000; ++k) heap.points.push_back({5.0, 0.0});
  heap.segments = {{{5.0, 0.0}, {5.0, 0.0}}};
  const std::vector<Body> one = bodies_among(heap);
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].representative, Vector2(5.0, 0.0));
  Course nowhere = ten_metres();
  nowhere.goal = nowhere.start;
  EXPECT_TRUE(bodies_of(heap, {mover_at({0, 0}, {0, 0})}, nowhere, {}).empty());
  Course point_robot = ten_metres();
  point_robot.robot_radius = point_robot.clearance = 0.0;
  EXPECT_EQ(bodies_of(heap, {}, point_robot, {}).size(), 1u);
}

}  // namespace
}  // namespace bw::homotopy
