#include "components/local_planner/teb/clearance_cost.hpp"

#include <gtest/gtest.h>

namespace bw::teb {
namespace {

TEST(ClearanceCost, DistanceToPointDiscAndSegment) {
  EXPECT_DOUBLE_EQ(clearance_to({{0, 0}, {0, 0}, 0.0}, {3, 4}).distance, 5.0);
  EXPECT_DOUBLE_EQ(clearance_to({{0, 0}, {0, 0}, 2.0}, {3, 4}).distance, 3.0);
  EXPECT_DOUBLE_EQ(clearance_to({{-1, 0}, {1, 0}, 0.5}, {0.3, 2}).distance, 1.5);
  EXPECT_DOUBLE_EQ(clearance_to({{-1, 0}, {1, 0}, 0.0}, {4, 4}).distance, 5.0);
  EXPECT_EQ(clearance_to({{0, 0}, {0, 0}, 0.0}, {0, 0}).gradient, Vector2(0.0, 0.0));
}

TEST(Associate, MoversAreWhereTheyWillBe) {
  // The robot needs 0.3 s per 0.3 m; the mover crosses x = 1.5 when pose 5 (t = 1.5 s) is there, and is far
  // from every other pose.
  Band band;
  for (int k = 0; k <= 10; ++k) band.poses.push_back({0.3 * k, 0.0, 0.0, 0.3});
  ObstacleField field;
  Mover mover;
  mover.position = {1.5, -6.0};
  mover.velocity = {0.0, 4.0};
  mover.radius = 0.1;
  field.movers = {mover};
  BandOptions options;
  options.clearance_step = 10.0;
  const std::vector<PoseTerms> terms = associate(band, field, options);
  for (std::size_t k = 0; k < terms.size(); ++k) {
    ASSERT_EQ(terms[k].at_pose.size(), k == 5 ? 1U : 0U) << k;
  }
  EXPECT_NEAR(terms[5].at_pose[0].capsule.a.y(), 0.0, 1e-12);
}

TEST(Associate, TestsBetweenPosesWhatMovesFarInOneInterval) {
  // A thin mover at 4 m/s passes the robot's line in the middle of an interval: 0.6 m away at both poses, on
  // the line between them.
  Band band;
  for (int k = 0; k <= 4; ++k) band.poses.push_back({0.1 * k, 0.0, 0.0, 0.3});
  ObstacleField field;
  Mover mover;
  mover.position = {0.15, -1.8};
  mover.velocity = {0.0, 4.0};
  mover.radius = 0.0;
  field.movers = {mover};
  BandOptions options;
  options.min_obstacle_dist = options.inflation_dist = options.dynamic_obstacle_inflation_dist = 0.1;
  const std::vector<PoseTerms> terms = associate(band, field, options);
  EXPECT_FALSE(terms[1].along_segment.empty());
}

TEST(NearbyObstacles, KeepsTheNearestAndGrowsThemByTheRobot) {
  StaticObstacles statics;
  for (int i = 0; i < 1000; ++i) statics.points.push_back({0.01 * (1000 - i), 0.0});
  const ObstacleField field = nearby_obstacles(statics, {}, {0.0, 0.0}, 0.25, 200);
  ASSERT_EQ(field.statics.size(), 200U);
  for (const Capsule& c : field.statics) {
    EXPECT_LE(c.a.x(), 2.0 + 1e-9);
    EXPECT_EQ(c.radius, 0.25);
  }
}

}  // namespace
}  // namespace bw::teb
