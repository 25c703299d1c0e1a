// The cone of a wall against where a robot really gets that keeps its velocity.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "components/local_planner/hrvo/cones.hpp"
#include "components/model/nearest_point.hpp"
#include "components/model/random.hpp"

namespace bw::hrvo {
namespace {

constexpr double kRadius = 0.6;

Neighbour wall(const Segment& core, const Vector2& robot) {
  return {core, kRadius, {0.0, 0.0}, false, (nearest_point(core, robot) - robot).norm()};
}

// Smallest distance to the wall over 25 m of travel in steps of 2 cm; its error is below 1 cm.
double nearest_on_the_path(const Segment& core, const Vector2& robot, const Vector2& v) {
  double nearest = 1e9;
  for (double travel = 0.0; travel < 25.0; travel += 0.02) {
    const Vector2 p = robot + travel * v.normalized();
    nearest = std::min(nearest, (nearest_point(core, p) - p).norm());
  }
  return nearest;
}

TEST(SegmentCone, HoldsTheVelocitiesThatReachTheSwollenSegment) {
  Random random(4);
  int contacts = 0, clear = 0;
  for (int scene = 0; scene < 100; ++scene) {
    const auto anywhere = [&] {
      const double x = random.uniform(-5.0, 5.0);
      return Vector2(x, random.uniform(-5.0, 5.0));
    };
    const Vector2 robot = anywhere();
    const Segment core{anywhere(), anywhere()};
    const Neighbour n = wall(core, robot);
    if (n.distance <= kRadius) continue;
    const VelocityCone cone = cone_of(n, {robot, {0.5, 0.0}, {0.5, 0.0}, 0.0}, {});
    EXPECT_GT(cross(cone.right, cone.left), 0.0);
    for (int k = 0; k < 30; ++k) {
      const Vector2 v = random.uniform(0.1, 1.0) * direction(random.uniform(-3.2, 3.2));
      const double nearest = nearest_on_the_path(core, robot, v);
      if (std::abs(nearest - kRadius) < 0.01) continue;
      EXPECT_EQ(is_inside(cone, v, 0.0), nearest < kRadius);
      ++(nearest < kRadius ? contacts : clear);
    }
  }
  EXPECT_GT(contacts, 300);
  EXPECT_GT(clear, 300);
}

TEST(SegmentCone, InsideTheSwollenSegmentAHalfPlane) {
  // A wall along x, 0.5 m to the left of the robot, radius 0.6: leave it at 0.1 m / 0.25 s = 0.4 m/s.
  const VelocityCone cone =
      cone_of(wall({{-3.0, 0.5}, {3.0, 0.5}}, {0.0, 0.0}), {{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}, 0.0}, {});
  EXPECT_NEAR(cone.apex.y(), -0.4, 1e-12);
  EXPECT_NEAR(cross(cone.right, cone.left), 0.0, 1e-12);
  EXPECT_TRUE(is_inside(cone, {1.0, 0.0}, 0.0));
  EXPECT_FALSE(is_inside(cone, {1.0, -0.41}, 0.0));
}

TEST(SegmentCone, AlongAWallIsFree) {
  const VelocityCone cone =
      cone_of(wall({{-3.0, 0.7}, {9.0, 0.7}}, {0.0, 0.0}), {{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}, 0.0}, {});
  EXPECT_FALSE(is_inside(cone, {1.0, 0.0}, 0.0));
  EXPECT_TRUE(is_inside(cone, {1.0, 0.05}, 0.0));
  EXPECT_FALSE(is_inside(cone, {-1.0, 0.0}, 0.0));
}

TEST(SegmentCone, APointIsASegmentWithoutLength) {
  const Vector2 p(2.0, 1.0);
  const VelocityCone point = cone_of(wall({p, p}, {0.0, 0.0}), {}, {});
  const VelocityCone tiny = cone_of(wall({p, p + Vector2(1e-9, 0.0)}, {0.0, 0.0}), {}, {});
  EXPECT_LT((point.left - tiny.left).norm(), 1e-8);
  EXPECT_LT((point.right - tiny.right).norm(), 1e-8);
}

}  // namespace
}  // namespace bw::hrvo
