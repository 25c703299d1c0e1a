#include "components/model/wheel_step.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "components/model/differential_drive.hpp"
#include "components/model/random.hpp"

namespace bw {
namespace {

// var(distance) = (0.3 + 0.1) k / 4, var(turn) = (0.3 + 0.1) k / b^2, cov = (0.3 - 0.1) k / (2 b).
TEST(WheelStep, WheelsGiveTheClosedForm) {
  const WheelStep step = step_from_wheels(Time{5}, Duration{3}, 0.1, 0.3, 0.4, 1e-3);
  EXPECT_NEAR(step.distance, 0.2, 1e-15);
  EXPECT_NEAR(step.turn, 0.5, 1e-15);
  EXPECT_NEAR(step.covariance(0, 0), 1e-4, 1e-18);
  EXPECT_NEAR(step.covariance(1, 1), 2.5e-3, 1e-16);
  EXPECT_NEAR(step.covariance(0, 1), 2.5e-4, 1e-17);
  EXPECT_EQ(step.covariance(0, 1), step.covariance(1, 0));
}

TEST(WheelStep, TwistTimesTime) {
  const Eigen::Matrix2d C = (Eigen::Matrix2d() << 0.04, 0.01, 0.01, 0.09).finished();
  const WheelStep step = step_from_twist(Time{0}, Duration::milliseconds(100), {0.5, -0.2}, C);
  EXPECT_NEAR(step.distance, 0.05, 1e-15);
  EXPECT_NEAR(step.turn, -0.02, 1e-15);
  EXPECT_NEAR(step.covariance(1, 1), 9e-4, 1e-15);
}

TEST(WheelStep, PosesOfAnArcGiveTheArcBack) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Pose2 from{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-3.1, 3.1)};
    const Twist2 arc{random.uniform(-1, 1), i % 5 == 0 ? 0.0 : random.uniform(-2, 2)};
    const WheelStep step =
        step_from_poses(Time{0}, Duration{1}, from, advance_exact(from, arc, 1.0), 0.4, 1e-3);
    ASSERT_NEAR(step.distance, arc.v, 1e-12);
    ASSERT_NEAR(step.turn, arc.omega, 1e-12);
  }
}

}  // namespace
}  // namespace bw
