// The pose that a killed localization leaves for the next one.
#include "components/localization/kept_pose.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace bw::localization {
namespace {

/// At 10 s the odometry said (1, 0, 0), and the robot was at (5, 5), heading along y.
KeptPose kept() {
  KeptPose k{
      .time = Time::seconds(10.0), .X_OB = {1.0, 0.0, 0.0}, .X_MB = {5.0, 5.0, 0.5 * std::numbers::pi}};
  k.covariance << 0.01, 0.001, 0.0, 0.001, 0.02, 0.0, 0.0, 0.0, 0.0004;
  return k;
}

// 0.5 m ahead by the odometry is 0.5 m along y on the map. The variances grow by (0.02 + 0.1 * 0.5)^2 + 0.5^2 * 0.0004 and by
// 0.02^2.
TEST(KeptPose, IsCarriedOnByTheOdometryAndLessSure) {
  const auto now = carried_on(kept(), {1.5, 0.0, 0.0}, Time::seconds(11.0));
  ASSERT_TRUE(now);
  EXPECT_NEAR(now->X_MB.x, 5.0, 1e-12);
  EXPECT_NEAR(now->X_MB.y, 5.5, 1e-12);
  EXPECT_NEAR(now->X_MB.theta, 0.5 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(now->covariance(0, 0), 0.01 + 0.0049 + 0.0001, 1e-12);
  EXPECT_NEAR(now->covariance(1, 1), 0.02 + 0.0049 + 0.0001, 1e-12);
  EXPECT_NEAR(now->covariance(2, 2), 0.0004 + 0.0004, 1e-12);
}

// A base that was started again too counts from (0, 0); 1 m in 0.3 s is more than 2 m/s and 0.2 m.
TEST(KeptPose, AnotherOdometryIsNotBelieved) {
  EXPECT_FALSE(carried_on(kept(), {0.0, 0.0, 0.0}, Time::seconds(10.3)));
  EXPECT_TRUE(carried_on(kept(), {1.7, 0.0, 0.0}, Time::seconds(10.3)));
  EXPECT_FALSE(carried_on(kept(), {1.0, 0.0, 0.0}, Time::seconds(9.0)));
}

}  // namespace
}  // namespace bw::localization
