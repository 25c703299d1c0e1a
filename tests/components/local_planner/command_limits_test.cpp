#include "components/local_planner/command_limits.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace bw {
namespace {

TEST(ReachableTwist, KeepsTheCurvatureWhenSpeedsSaturate) {
  Limits limits;
  limits.acc_max = limits.alpha_max = 20.0;
  const Twist2 t = reachable_twist({2.0, 1.0}, {1.0, 0.5}, limits, 0.1);
  EXPECT_DOUBLE_EQ(t.v, 1.0);
  EXPECT_DOUBLE_EQ(t.omega, 0.5);
}

TEST(ReachableTwist, ChangesNoFasterThanTheAccelerations) {
  const Limits limits;  // 1 m/s^2, 1.5 rad/s^2
  const Twist2 t = reachable_twist({1.0, -1.0}, {0.2, 0.3}, limits, 0.1);
  EXPECT_NEAR(t.v, 0.3, 1e-12);
  EXPECT_NEAR(t.omega, 0.15, 1e-12);
}

TEST(ReachableTwist, LimitsBackwardSpeed) {
  const Limits limits;
  EXPECT_NEAR(reachable_twist({-1.0, 0.0}, {-0.15, 0.0}, limits, 0.1).v, -0.2, 1e-12);
}

TEST(SmoothTwist, LeadsBackFromOutsideTheLimitsWithinTheAcceleration) {
  // From 5 m/s, 4 above v_max, braking already: 1 m/s^2 for 0.1 s. Backward the same.
  const Limits limits;
  EXPECT_NEAR(smooth_twist({0.5, 0.0}, {5.0, 0.0}, -1.0, limits, 0.1, 0.1).v, 4.9, 1e-12);
  EXPECT_NEAR(smooth_twist({0.5, 0.0}, {-5.0, 0.0}, 1.0, limits, 0.1, 0.1).v, -4.9, 1e-12);
  // A last acceleration from other limits counts for no more than acc_max.
  EXPECT_NEAR(smooth_twist({1.0, 0.0}, {0.0, 0.0}, 20.0, limits, 0.1, 0.1).v, 0.1, 1e-12);
}

TEST(StopTwist, BrakesWithStopDecelerationAndEndsAtRest) {
  const Limits limits;  // 2 m/s^2, 1.5 rad/s^2
  Twist2 t{0.5, -0.2};
  t = stop_twist(t, limits, 0.1);
  EXPECT_NEAR(t.v, 0.3, 1e-12);
  EXPECT_NEAR(t.omega, -0.05, 1e-12);
  t = stop_twist(stop_twist(t, limits, 0.1), limits, 0.1);
  EXPECT_EQ(t, Twist2{});
  EXPECT_EQ(stop_twist({std::nan(""), 0.0}, limits, 0.1), Twist2{});
}

TEST(StopTwist, NeverSpeedsUp) {
  // A period that is none says nothing about braking: a negative one would turn it round.
  const Limits limits;
  for (const double period : {0.0, -0.1, std::nan("")})
    EXPECT_EQ(stop_twist({0.5, -0.2}, limits, period), Twist2{});
}

}  // namespace
}  // namespace bw
