#include "components/local_planner/mppi/rollouts.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "components/model/differential_drive.hpp"
#include "components/model/random.hpp"

namespace bw::mppi {
namespace {

constexpr double kStep = 0.05;
constexpr Limits kAnything{
    .v_max = 1e3, .v_back_max = 1e3, .omega_max = 1e3, .acc_max = 1e5, .alpha_max = 1e5};

// The arcs of the model (model/README.md 2.1), one after the other. 1e-12 m is what 56 sums of doubles leave.
TEST(Rollouts, AreExactArcs) {
  constexpr Eigen::Index kSamples = 50, kSteps = 56;
  for (const double spread :
       {0.3, 3.0, 60.0}) {  // [rad/s]; beyond 10 rad/s a step rotates by more than the series takes
    Random random(5);
    Rollouts rollouts;
    rollouts.resize(kSamples, kSteps);
    for (Eigen::Index i = 0; i < kSamples; ++i) {
      for (Eigen::Index k = 0; k < kSteps; ++k) {
        rollouts.command_v(i, k) = random.normal(0.5, 0.5);
        rollouts.command_omega(i, k) = i == 0 ? 0.0 : random.normal(0.0, spread);
      }
    }
    const Twist2 now{0.4, -0.2};
    roll_out(rollouts, now, kAnything, kStep);
    for (Eigen::Index i = 0; i < kSamples; ++i) {
      Pose2 pose;
      double heading = 0.0;
      for (Eigen::Index k = 0; k < kSteps; ++k) {
        const Twist2 twist =
            k == 0 ? now : Twist2{rollouts.command_v(i, k - 1), rollouts.command_omega(i, k - 1)};
        pose = advance_exact(pose, twist, kStep);
        heading += twist.omega * kStep;
        ASSERT_EQ(rollouts.v(i, k), twist.v);
        ASSERT_EQ(rollouts.omega(i, k), twist.omega);
        ASSERT_NEAR(rollouts.x(i, k), pose.x, 1e-12) << spread << " " << i << " " << k;
        ASSERT_NEAR(rollouts.y(i, k), pose.y, 1e-12) << spread << " " << i << " " << k;
        ASSERT_NEAR(rollouts.theta(i, k), heading, 1e-12);
      }
    }
  }
}

// A circle of radius v / omega = 0.5 m: after a whole revolution of 2 pi / 1.6 s the robot is where it was,
// after half of it 1 m aside.
TEST(Rollouts, CloseACircle) {
  constexpr Eigen::Index kSteps = 40;
  const double omega = 2.0 * std::numbers::pi / (kSteps * kStep);
  Rollouts rollouts;
  rollouts.resize(1, kSteps);
  rollouts.command_v.setConstant(0.5 * omega);
  rollouts.command_omega.setConstant(omega);
  roll_out(rollouts, {0.5 * omega, omega}, kAnything, kStep);
  EXPECT_NEAR(rollouts.x(0, kSteps / 2 - 1), 0.0, 1e-12);
  EXPECT_NEAR(rollouts.y(0, kSteps / 2 - 1), 1.0, 1e-12);
  EXPECT_NEAR(rollouts.x(0, kSteps - 1), 0.0, 1e-12);
  EXPECT_NEAR(rollouts.y(0, kSteps - 1), 0.0, 1e-12);
  EXPECT_NEAR(rollouts.theta(0, kSteps - 1), 2.0 * std::numbers::pi, 1e-12);
}

// 2 m/s^2 0.05 s = 0.1 m/s, 4 rad/s^2 0.05 s = 0.2 rad/s from what is driven, the first step at the present
// velocity.
TEST(Rollouts, KeepTheAccelerations) {
  const Limits limits{.v_max = 0.3, .acc_max = 2.0, .alpha_max = 4.0};
  Rollouts rollouts;
  rollouts.resize(1, 5);
  rollouts.command_v.row(0) << 5.0, 5.0, 0.75, -5.0, 9.0;
  rollouts.command_omega.row(0) << -5.0, -5.0, 0.0, 0.05, 9.0;
  roll_out(rollouts, {0.5, 0.0}, limits, kStep);
  const double v[] = {0.5, 0.6, 0.7, 0.75, 0.65};
  const double omega[] = {0.0, -0.2, -0.4, -0.2, 0.0};
  EXPECT_EQ(rollouts.command_v(0, 0), 5.0);
  cut_commands(rollouts);
  for (Eigen::Index k = 0; k < 5; ++k) {
    EXPECT_NEAR(rollouts.v(0, k), v[k], 1e-12) << k;
    EXPECT_NEAR(rollouts.omega(0, k), omega[k], 1e-12) << k;
    if (k == 4) continue;  // nobody drives the last command
    EXPECT_EQ(rollouts.command_v(0, k), rollouts.v(0, k + 1)) << k;
    EXPECT_EQ(rollouts.command_omega(0, k), rollouts.omega(0, k + 1)) << k;
  }
  EXPECT_EQ(rollouts.command_v(0, 4), 9.0);
}

}  // namespace
}  // namespace bw::mppi
