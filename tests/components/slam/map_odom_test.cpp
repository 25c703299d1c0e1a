#include "components/slam/map_odom.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/components/slam/slam_scene.hpp"

namespace bw::slam {
namespace {

// A correction of 0.3 m and 0.1 rad comes in steps of at most 15 mm and 7 mrad of the robot's pose: after 20,
// or one more by rounding, it is all there, to the bit.
TEST(MapToOdom, FeedsACorrectionInOverTime) {
  const Pose2 X_OB{3.0, -2.0, 0.7};
  MapToOdom transform;
  const Pose2 wanted{0.3, 0.0, 0.0};
  transform.set(wanted);
  Pose2 before = X_OB;
  int steps = 0;
  while (transform.told() != wanted && steps < 100) {
    const Pose2 at = transform.next(X_OB) * X_OB;
    EXPECT_LE(test::distance(at, before), 0.015 + 1e-9);
    EXPECT_LE(std::abs(wrap_angle(at.theta - before.theta)), 0.007 + 1e-9);
    before = at;
    ++steps;
  }
  EXPECT_NEAR(steps, 20, 1);
  transform.set({0.3, 0.0, 0.1});
  for (steps = 0; transform.told().theta != 0.1 && steps < 100; ++steps) transform.next({});
  EXPECT_EQ(steps, 15) << "0.1 / 0.007, rounded up";
  transform.jump({5.0, 5.0, 1.0});
  EXPECT_EQ(transform.next(X_OB), (Pose2{5.0, 5.0, 1.0}));
}

}  // namespace
}  // namespace bw::slam
