#include "components/local_planner/homotopy/edge_check.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "components/local_planner/homotopy/segment_distance.hpp"
#include "tests/components/local_planner/homotopy/scenes.hpp"

namespace bw::homotopy {
namespace {

TEST(EdgeCheck, KeepsTheClearance) {
  // A disc of 0.5 m at (5, 0), robot 0.3 m, clearance 0.1 m: free from 0.9 m beside its centre on.
  const std::vector<Body> bodies{standing({5.0, 0.0}, 0.5)};
  const EdgeCheck check(ten_metres(), bodies, 0.1);
  EXPECT_FALSE(check.clear({3.0, 0.899}, {7.0, 0.899}));
  EXPECT_TRUE(check.clear({3.0, 0.901}, {7.0, 0.901}));
  EXPECT_TRUE(check.clear({3.0, -0.901}, {7.0, -0.901}));
  EXPECT_FALSE(check.clear({3.0, 0.0}, {7.0, 0.0}));
}

TEST(EdgeCheck, AgreesWithDenseSampling) {
  Random random(6);
  int blocked = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Vector2 a{random.uniform(3, 7), random.uniform(-2, 2)};
    const Vector2 b = random.uniform() < 0.5 ? a : Vector2(random.uniform(3, 7), random.uniform(-2, 2));
    Body body = standing(0.5 * (a + b), 0.2);
    body.parts[0].axis = {a, b};
    const Vector2 from{random.uniform(1, 9), random.uniform(-3, 3)};
    const Vector2 to{random.uniform(1, 9), random.uniform(-3, 3)};
    double nearest = INFINITY;
    for (int k = 0; k <= 400; ++k) {
      const Vector2 p = from + (k / 400.0) * (to - from);
      nearest = std::min(nearest, std::sqrt(squared_distance(p, body.parts[0].axis)) - 0.2 - 0.3);
    }
    if (std::abs(nearest - 0.1) < 0.03) continue;  // too close to call between the samples
    EXPECT_EQ(EdgeCheck(ten_metres(), {body}, 0.1).clear(from, to), nearest > 0.1);
    blocked += nearest < 0.1;
  }
  EXPECT_GT(blocked, 300);
}

TEST(EdgeCheck, MoversAreWhereTheyAreWhenTheRobotPasses) {
  // On the line at x = 5 after 4 s, the robot after 5 s: 1 m between their centres is enough. Half a metre
  // per second slower, they meet.
  Body walker = standing({5.0, 0.0}, 0.3);
  for (const double speed : {1.0, 0.8}) {
    walker.motion = mover_at({5.0, -4.0}, {0.0, speed});
    const bool expected = speed == 1.0;
    EXPECT_EQ(EdgeCheck(ten_metres(), {walker}, 0.1).clear({0.0, 0.0}, {10.0, 0.0}), expected);
    walker.motion->predictions = {{1.0, {5.0, -4.0 + speed}}, {5.0, {5.0, -4.0 + 5.0 * speed}}};
    EXPECT_EQ(EdgeCheck(ten_metres(), {walker}, 0.1).clear({0.0, 0.0}, {10.0, 0.0}), expected);
  }
}

TEST(EdgeCheck, ARobotRightBehindSomebodyFindsAWayRound) {
  // Gap 0.05 m. The edge to (0.65, 0.9) comes as close as 0.65 sin(54.2 deg) = 0.527 m to the centre;
  // 0.65 - 0.5 * 0.3 = 0.5 is allowed, so to (0.65, 0.7), 0.476 m, there is none.
  const std::vector<Body> bodies{standing({0.65, 0.0}, 0.3)};
  const EdgeCheck check(ten_metres(), bodies, 0.1);
  EXPECT_TRUE(check.clear({0.0, 0.0}, {0.65, 0.9}));
  EXPECT_FALSE(check.clear({0.0, 0.0}, {0.65, 0.7}));
  EXPECT_FALSE(check.clear({0.01, 0.0}, {0.65, 0.9}));  // elsewhere than at the start
}

TEST(EdgeCheck, ARobotInAnObstacleMayLeaveItButNotCrossIt) {
  const std::vector<Body> bodies{standing({0.3, 0.0}, 0.5), standing({9.8, 0.0}, 0.5)};
  const EdgeCheck check(ten_metres(), bodies, 0.1);
  EXPECT_TRUE(check.clear({0.0, 0.0}, {0.0, 2.0}));
  EXPECT_FALSE(check.clear({0.0, 0.0}, {5.0, 0.0}));
  EXPECT_TRUE(check.clear({10.0, 2.0}, {10.0, 0.0}));
  EXPECT_FALSE(check.clear({5.0, 0.0}, {10.0, 0.0}));
}

TEST(SegmentDistance, ClosedForms) {
  const Segment flat{{0, 0}, {4, 0}};
  EXPECT_DOUBLE_EQ(squared_distance(Vector2(2, 3), flat), 9.0);
  EXPECT_DOUBLE_EQ(squared_distance(Vector2(7, 4), flat), 25.0);
  EXPECT_DOUBLE_EQ(squared_distance(flat, Segment{{1, -1}, {3, 1}}), 0.0);
  EXPECT_DOUBLE_EQ(squared_distance(flat, Segment{{1, 2}, {3, 1}}), 1.0);
  EXPECT_DOUBLE_EQ(squared_distance(flat, Segment{{6, 0}, {9, 0}}), 4.0);  // on one line
  EXPECT_DOUBLE_EQ(squared_distance(flat, Segment{{4, 0}, {4, 5}}), 0.0);  // touching
  EXPECT_DOUBLE_EQ(squared_distance(Segment{{2, 2}, {2, 2}}, flat), 4.0);  // a point
}

}  // namespace
}  // namespace bw::homotopy
