#include "components/local_planner/dwa/velocity_window.hpp"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bw::dwa {
namespace {

using ::testing::Contains;

// Table 3.1: 1 m/s, 0.35 rad/s, 0.25 s; 1 m/s^2 and 1 rad/s^2 by model/README.md 2.3.
const Limits kTable = {.v_max = 1.0, .omega_max = 0.35, .acc_max = 1.0, .alpha_max = 1.0};
constexpr double kPeriod = 0.25;

TEST(VelocityWindow, IsWhatTheAccelerationsReach) {
  const VelocityWindow window = velocity_window({0.5, 0.05}, kTable, 1.0, kPeriod);
  EXPECT_EQ(window.v, (Interval{0.25, 0.75}));
  EXPECT_DOUBLE_EQ(window.omega.low, -0.20);
  EXPECT_DOUBLE_EQ(window.omega.high, 0.30);
}

TEST(VelocityWindow, IsCutAtWhatTheRobotMayDo) {
  const VelocityWindow window = velocity_window({0.9, 0.3}, kTable, 1.0, kPeriod);
  EXPECT_EQ(window.v, (Interval{0.65, 1.0}));
  EXPECT_EQ(window.omega.high, 0.35);
  EXPECT_EQ(velocity_window({0.1, 0.0}, kTable, 1.0, kPeriod).v, (Interval{0.0, 0.35}));
}

TEST(VelocityWindow, OutsideTheLimitsLeadsBackAsFastAsAllowed) {
  EXPECT_EQ(velocity_window({1.0, 0.0}, kTable, 0.5, kPeriod).v, (Interval{0.75, 0.75}));
  EXPECT_EQ(velocity_window({-0.5, 0.0}, kTable, 1.0, kPeriod).v, (Interval{-0.25, -0.25}));
  EXPECT_EQ(velocity_window({0.0, 1.0}, kTable, 1.0, kPeriod).omega, (Interval{0.75, 0.75}));
}

TEST(VelocitySamples, HoldEdgesPresentVelocityStandingAndStraight) {
  const Twist2 now{0.13, 0.071};
  const VelocityWindow window = velocity_window(now, kTable, 1.0, kPeriod);
  const std::vector<Twist2> samples = velocity_samples(window, now, 11, 21);
  EXPECT_THAT(samples, Contains(now));
  EXPECT_THAT(samples, Contains(Twist2{0.0, 0.0}));
  EXPECT_THAT(samples, Contains(Twist2{now.v, 0.0}));
  EXPECT_THAT(samples, Contains(Twist2{window.v.high, window.omega.low}));
  // 11 x 21, a row for the present speed, which is not the middle of the cut interval, and a column for zero.
  EXPECT_EQ(samples.size(), 12U * 22U);
}

TEST(VelocitySamples, SymmetricWindowNeedsNoExtraOnes) {
  // From 0.5 m/s straight on, the middle of 11 x 21 is the present velocity.
  const VelocityWindow window = velocity_window({0.5, 0.0}, kTable, 1.0, kPeriod);
  EXPECT_EQ(velocity_samples(window, {0.5, 0.0}, 11, 21).size(), 11U * 21U);
}

TEST(VelocitySamples, WindowOfOneVelocityIsOneSample) {
  EXPECT_EQ(velocity_samples({{0.75, 0.75}, {0.0, 0.0}}, {1.0, 0.0}, 11, 21).size(), 1U);
}

}  // namespace
}  // namespace bw::dwa
