#include "components/model/wheel_step.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "components/model/differential_drive.hpp"
#include "components/model/random.hpp"

namespace bw {
namespace {

// var(distance) = (0.3 + 0.1) k / 4, var(rotation) = (0.3 + 0.1) k / b^2, cov = (0.3 - 0.1) k / (2 b).
TEST(WheelStep, WheelsGiveTheClosedForm) {
  const WheelStep step = step_from_wheels(Time{5}, Duration{3}, 0.1, 0.3, 0.4, 1e-3);
  EXPECT_NEAR(step.distance, 0.2, 1e-15);
  EXPECT_NEAR(step.rotation, 0.5, 1e-15);
  EXPECT_NEAR(step.covariance(0, 0), 1e-4, 1e-18);
  EXPECT_NEAR(step.covariance(1, 1), 2.5e-3, 1e-16);
  EXPECT_NEAR(step.covariance(0, 1), 2.5e-4, 1e-17);
  EXPECT_EQ(step.covariance(0, 1), step.covariance(1, 0));
}

TEST(WheelStep, TwistTimesTime) {
  const Eigen::Matrix2d C = (Eigen::Matrix2d() << 0.04, 0.01, 0.01, 0.09).finished();
  const WheelStep step = step_from_twist(Time{0}, Duration::milliseconds(100), {0.5, -0.2}, C);
  EXPECT_NEAR(step.distance, 0.05, 1e-15);
  EXPECT_NEAR(step.rotation, -0.02, 1e-15);
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
    ASSERT_NEAR(step.rotation, arc.omega, 1e-12);
  }
}

// What an odometry declares is read back exactly, whatever the way; one that declares nothing is told.
TEST(WheelStep, TheNoiseOfTheWheelsIsReadBackFromTheCovarianceOfTheOdometry) {
  Random random(4);
  Pose2 X_OB;
  Eigen::Matrix3d C = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 1000; ++i) {
    const WheelStep step = step_from_wheels(Time{0}, Duration{1}, random.uniform(-0.01, 0.02),
                                            random.uniform(-0.01, 0.02), 0.4, 1e-4);
    const Eigen::Matrix3d before = C;
    C = covariance_after(X_OB, C, step);
    const Pose2 from = X_OB;
    X_OB = advance_arc(X_OB, step.distance, step.rotation);
    const auto k = declared_variance_per_metre(before(2, 2), C(2, 2), arc_between(from, X_OB), 0.4);
    ASSERT_TRUE(k);
    ASSERT_NEAR(*k, 1e-4, 1e-11);
  }
  EXPECT_FALSE(declared_variance_per_metre(0.1, 0.1, {0.02, 0.0}, 0.4));  // a covariance that stays
  EXPECT_FALSE(declared_variance_per_metre(0.1, 0.0, {0.02, 0.0}, 0.4));  // a base that began anew
  EXPECT_FALSE(declared_variance_per_metre(0.0, 0.1, {0.0, 0.0}, 0.4));   // a base that stands
}

}  // namespace
}  // namespace bw
