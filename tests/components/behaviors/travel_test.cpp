// Motions in the open: they end on their target at rest, within the limits, whatever base obeys. Expected:
// the target itself.
#include "components/behaviors/travel.hpp"

#include <limits>
#include <random>

#include <gmock/gmock.h>

#include "tests/components/behaviors/behavior_drive.hpp"

namespace bw {
namespace {

using State = BehaviorStep::State;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::unique_ptr<Behavior> spin(const BehaviorDrive& d, double yaw, double allowance = 0.0) {
  return make_spin({.target_yaw = yaw, .time_allowance = Duration::seconds(allowance)}, d.options,
                   BehaviorDrive::begin());
}
std::unique_ptr<Behavior> drive(const BehaviorDrive& d, double x, double speed, double allowance = 0.0) {
  return make_drive_on_heading(
      {.target = {x, 0.0}, .speed = speed, .time_allowance = Duration::seconds(allowance)}, d.options,
      d.robot.limits, BehaviorDrive::begin());
}

// Arrival is called within kTolerance; after that the base may still come to rest from what is_at_rest() lets
// pass.
constexpr double kEnd = Travel::kTolerance + 1e-3;

class OnTarget : public testing::TestWithParam<std::tuple<Base, double>> {};
INSTANTIATE_TEST_SUITE_P(Travel, OnTarget,
                         testing::Combine(testing::Values(Base::obeys_at_once, Base::limiter),
                                          testing::Values(10.0, 20.0, 50.0)));

TEST_P(OnTarget, SpinEndsAtTheAngleAskedForAtRest) {
  for (const double yaw : {1.57, -1.57, 3.0, -3.0, 6.28, -6.28, 12.0, 0.1, -0.02}) {
    BehaviorDrive d{.base = std::get<0>(GetParam()), .start = {2.0, -1.0, 3.0}};
    d.options.cycle_frequency = std::get<1>(GetParam());
    d.run(*spin(d, yaw));
    EXPECT_EQ(d.last.state, State::succeeded) << yaw << " " << d.last.text;
    EXPECT_NEAR(d.rotated, yaw, kEnd);
    EXPECT_NEAR(d.last.traveled, yaw, kEnd);
    EXPECT_EQ(d.twist, Twist2{}) << yaw;
    EXPECT_EQ(d.pose.position(), Vector2(2.0, -1.0));
    // At 1 rad/s and 1.5 rad/s^2, and a second for the base to get going and to settle.
    EXPECT_LT(d.time, std::abs(yaw) / 1.0 + 1.0 / 1.5 + 1.5) << yaw;
  }
}

TEST_P(OnTarget, DriveAndBackupEndAtTheDistanceAskedForAtRest) {
  const Pose2 start{2.0, -1.0, 2.5};
  for (const auto& [x, speed] :
       {std::pair{0.3, 0.15}, {-0.3, -0.05}, {0.3, 1.0}, {2.0, 0.5}, {-1.0, -0.2}, {0.03, 0.3}}) {
    BehaviorDrive d{.base = std::get<0>(GetParam()), .start = start};
    d.options.cycle_frequency = std::get<1>(GetParam());
    d.run(*drive(d, x, speed));
    EXPECT_EQ(d.last.state, State::succeeded) << x << " " << d.last.text;
    const Vector2 moved = inverse(start) * d.pose.position();
    EXPECT_NEAR(moved.x(), x, kEnd);
    EXPECT_NEAR(moved.y(), 0.0, 1e-9);
    EXPECT_NEAR(d.last.traveled, std::abs(x), kEnd) << "Nav2 tells it without a sign";
    EXPECT_EQ(d.twist, Twist2{});
    for (const Twist2& command : d.commands) EXPECT_LE(std::abs(command.v), std::abs(speed) + 1e-9);
    EXPECT_LT(d.time, std::abs(x / speed) + std::abs(speed) / 1.0 + 2.0) << x;
  }
}

TEST(Travel, BackupGoesBackWhateverTheSigns) {
  for (const auto& [x, speed] : {std::pair{0.3, 0.1}, {-0.3, 0.1}, {0.3, -0.1}, {-0.3, -0.1}}) {
    BehaviorDrive d;
    d.run(*make_back_up({.target = {x, 0.0}, .speed = speed}, d.options, d.robot.limits,
                        BehaviorDrive::begin()));
    EXPECT_EQ(d.last.state, State::succeeded);
    EXPECT_NEAR(d.pose.x, -0.3, kEnd);
  }
}

TEST(Travel, ARobotThatMovesComesToRestFirstAndTheWayCountsFromThere) {
  BehaviorDrive d{.start_twist = {0.8, 0.5}};
  d.run(*drive(d, 0.5, 0.3));
  EXPECT_EQ(d.last.state, State::succeeded);
  EXPECT_EQ(d.commands.front(), Twist2{});
  EXPECT_NEAR(d.last.traveled, 0.5, kEnd);
  // 0.8 m/s is stopped within 0.32 m at 1 m/s^2, and 0.16 s of jerk.
  EXPECT_GT(d.pose.position().norm(), 0.5 + 0.25);

  BehaviorDrive back{.start_twist = {0.8, 0.0}};
  back.run(*make_back_up({.target = {0.3, 0.0}, .speed = 0.2}, back.options, back.robot.limits,
                         BehaviorDrive::begin()));
  EXPECT_EQ(back.last.state, State::succeeded);
  EXPECT_NEAR(back.last.traveled, 0.3, kEnd);
}

// 300 goals of any size on robots of any limits: the end comes, within the allowance, and no command is more
// than the base can do.
TEST(Travel, RandomGoalsKeepTheLimitsAndEndWithinTheirAllowance) {
  std::mt19937_64 random(20261122);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  int succeeded = 0, timed_out = 0;
  for (int trial = 0; trial < 300; ++trial) {
    BehaviorDrive d{.base = trial % 2 == 0 ? Base::limiter : Base::obeys_at_once};
    Limits& limits = d.robot.limits;
    limits = {.v_max = uniform(0.2, 1.5),
              .v_back_max = uniform(0.05, 0.5),
              .omega_max = uniform(0.3, 3.0),
              .acc_max = uniform(0.3, 1.5),
              .alpha_max = uniform(0.5, 4.0),
              .jerk_max = uniform(3.0, 20.0),
              .stop_deceleration = 2.0};
    d.start = {uniform(-5, 5), uniform(-5, 5), uniform(-3, 3)};
    if (d.base == Base::limiter) d.start_twist = {uniform(0.0, limits.v_max), uniform(-0.3, 0.3)};
    d.options.min_rotational_vel = uniform(0.0, 0.3);
    const double allowance = uniform(0.2, 15.0);
    const bool is_rotation = uniform(0, 1) < 0.5;
    const double size = uniform(-4.0, 4.0);
    const auto behavior = is_rotation ? spin(d, size, allowance)
                                      : drive(d, size, std::copysign(uniform(0.02, 2.0), size), allowance);
    d.run(*behavior);
    ASSERT_NE(d.last.state, State::running) << trial;
    ASSERT_EQ(d.commands.back(), Twist2{});
    ASSERT_EQ(d.twist, Twist2{});
    // One cycle to notice it, and the time to come to rest.
    ASSERT_LE(d.time, allowance + 0.2 + limits.v_max / limits.acc_max + 1.0) << trial;
    Twist2 before;
    for (const Twist2& command : d.commands) {
      ASSERT_LE(command.v, limits.v_max + 1e-9);
      ASSERT_GE(command.v, -limits.v_back_max - 1e-9);
      ASSERT_LE(std::abs(command.omega), limits.omega_max + 1e-9);
      if (command != Twist2{}) {
        ASSERT_LE(std::abs(command.v - before.v), limits.acc_max * 0.1 + 1e-9) << trial;
        ASSERT_LE(std::abs(command.omega - before.omega), limits.alpha_max * 0.1 + 1e-9) << trial;
      }
      before = command;
    }
    if (d.last.state == State::succeeded) {
      ++succeeded;
      // The slowest rotation goes on for the lag of the base before it ends.
      ASSERT_NEAR(d.last.traveled, is_rotation ? size : std::abs(size),
                  0.01 + 0.1 * d.options.min_rotational_vel)
          << trial;
    } else {
      ++timed_out;
      ASSERT_EQ(d.last.error, BehaviorError::timeout) << d.last.text;
    }
  }
  EXPECT_GT(succeeded, 100);
  EXPECT_GT(timed_out, 50);
}

TEST(Travel, TheAllowanceEndsItAndNoneIsNone) {
  BehaviorDrive d;
  d.run(*spin(d, 6.0, 2.0));
  EXPECT_EQ(d.last.state, State::failed);
  EXPECT_EQ(d.last.error, BehaviorError::timeout);
  EXPECT_EQ(d.last.text, "the time allowance was over before the target was reached");
  EXPECT_EQ(d.last.command, Twist2{});
  EXPECT_GT(d.last.traveled, 1.0);
  BehaviorDrive negative;
  negative.run(*spin(negative, 6.0, -1.0));
  EXPECT_EQ(negative.last.state, State::succeeded);
}

// What holds the robot is not seen by the odometry: no allowance, so after 10 s.
TEST(Travel, WithoutAnAllowanceARobotThatIsHeldGivesUp) {
  BehaviorDrive d;
  d.spoil = [](double, BehaviorSituation& s) {
    s.problem.pose = {};
    s.problem.twist = {};
  };
  d.run(*drive(d, 1.0, 0.3));
  EXPECT_EQ(d.last.error, BehaviorError::unknown);
  EXPECT_EQ(d.last.text, "the robot does not move");
  EXPECT_NEAR(static_cast<double>(d.commands.size()), 102.0, 1.0);

  BehaviorDrive charging;
  charging.spoil = [&d](double t, BehaviorSituation& s) {
    d.spoil(t, s);
    s.base_stop = BaseStop{.reason = "the charger is plugged in"};
  };
  charging.run(*drive(charging, 1.0, 0.3));
  EXPECT_EQ(charging.last.text, "the robot does not move; the base stands: the charger is plugged in");
}

TEST(Travel, WhatIsMissingOrNoNumberEndsItWithTfError) {
  BehaviorDrive missing;
  missing.spoil = [](double t, BehaviorSituation& s) {
    if (t > 1.0) s.missing = "no odometry yet";
  };
  missing.run(*spin(missing, 3.0));
  EXPECT_EQ(missing.last.error, BehaviorError::tf_error);
  EXPECT_EQ(missing.last.text, "no odometry yet");
  EXPECT_EQ(missing.last.command, Twist2{});
  BehaviorDrive blind;
  blind.spoil = [](double, BehaviorSituation& s) { s.unseen = "no obstacles yet"; };
  blind.run(*spin(blind, 3.0));
  EXPECT_EQ(blind.last.error, BehaviorError::tf_error);
  EXPECT_EQ(blind.last.text, "no obstacles yet");
  blind.run(*make_spin({.target_yaw = 3.0, .disable_collision_checks = true}, blind.options,
                       BehaviorDrive::begin()));
  EXPECT_EQ(blind.last.state, State::succeeded) << "who does not look need not see";
  BehaviorDrive nan;
  nan.spoil = [](double t, BehaviorSituation& s) {
    if (t > 1.0) s.problem.pose.theta = kNan;
  };
  nan.run(*spin(nan, 3.0));
  EXPECT_EQ(nan.last.error, BehaviorError::tf_error);
  EXPECT_EQ(nan.last.text, "the robot pose is not finite");
}

// A simulation begins again at second 1 of a spin: the allowance of 5 s goes on.
TEST(Travel, AClockThatGoesBackNeitherEndsNorProlongsIt) {
  BehaviorDrive d;
  d.spoil = [](double t, BehaviorSituation& s) {
    if (t > 1.0) s.problem.now = s.problem.now - Duration::seconds(900.0);
    s.problem.pose = {};
    s.problem.twist = {};
  };
  d.run(*spin(d, 3.0, 5.0));
  EXPECT_EQ(d.last.error, BehaviorError::timeout);
  EXPECT_NEAR(static_cast<double>(d.commands.size()), 53.0, 1.5);
}

}  // namespace
}  // namespace bw
