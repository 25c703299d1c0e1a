#include "components/robot_base/wheel_watchdog.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "components/model/random.hpp"
#include "components/model/stopping.hpp"

namespace bw {
namespace {

constexpr Duration kPeriod = Duration::milliseconds(10);
constexpr double kDeceleration = 2.0;
constexpr double kAcceleration = 1.0;
constexpr WatchdogOptions kQuarter{.timeout = 0.25};

TEST(Brake, KeepsTheCurvatureAndEndsAtRest) {
  const WheelSpeeds wheels = brake({0.5, 1.0}, 2.0, 0.1);  // the faster loses 0.2
  EXPECT_NEAR(wheels.right, 0.8, 1e-15);
  EXPECT_NEAR(wheels.left, 0.4, 1e-15);
  EXPECT_EQ(brake({-0.1, 0.1}, 2.0, 0.1), WheelSpeeds{});
  EXPECT_EQ(brake({}, 2.0, 0.1), WheelSpeeds{});
}

TEST(WheelWatchdog, StandsUntilTheFirstCommand) {
  WheelWatchdog watchdog(kQuarter, kDeceleration, kAcceleration);
  for (int i = 0; i < 100; ++i) {
    const WatchdogOutput output = watchdog.step(Time{} + kPeriod * i);
    EXPECT_EQ(output.state, WatchdogState::waiting);
    EXPECT_EQ(output.wheels, WheelSpeeds{});
  }
  EXPECT_EQ(watchdog.timeouts(), 0U);
}

TEST(WheelWatchdog, BrakingBeginsWithin260MsOfTheLastCommandAndEndsAfterVOverA) {
  // Commands every 20 ms until some phase within the check period; then silence. 1 m/s at 2 m/s^2: at rest
  // 0.5 s later.
  constexpr std::uint64_t kSeed = 3;
  Random random(kSeed);
  for (int run = 0; run < 200; ++run) {
    WheelWatchdog watchdog(kQuarter, kDeceleration, kAcceleration);
    const Time last_command =
        Time::seconds(5.0) + Duration{static_cast<std::int64_t>(random.uniform(0.0, 10e6))};
    Time now = Time::seconds(4.0);
    Time command_at = last_command - Duration::milliseconds(20) * 50;
    Time first_braking{};
    Time at_rest{};
    double previous = 0.0;
    while (now < Time::seconds(7.0)) {
      while (command_at <= now && command_at <= last_command) {
        ASSERT_TRUE(watchdog.command(command_at, {1.0, 1.0}));
        command_at = command_at + Duration::milliseconds(20);
      }
      const WatchdogOutput output = watchdog.step(now);
      if (output.wheels.left < 1.0 && previous == 1.0) first_braking = now;
      if (output.state == WatchdogState::stopped && at_rest == Time{}) at_rest = now;
      if (first_braking != Time{}) {
        ASSERT_GE(output.wheels.left, previous - kDeceleration * 0.01 - 1e-12);
        const double age = (now - last_command).to_seconds();
        ASSERT_NEAR(output.wheels.left, std::max(0.0, 1.0 - kDeceleration * (age - 0.25)), 1e-12);
        ASSERT_EQ(output.wheels.left, output.wheels.right);
      }
      previous = output.wheels.left;
      now = now + kPeriod;
    }
    const double begins = (first_braking - last_command).to_seconds();
    EXPECT_GE(begins, 0.25) << "seed " << kSeed << " run " << run;
    EXPECT_LE(begins, 0.26);
    EXPECT_NEAR((at_rest - last_command).to_seconds(), 0.755, 0.005001);  // 0.25 + 0.5, and the next check
    EXPECT_EQ(watchdog.timeouts(), 1U);
  }
}

TEST(WheelWatchdog, AFreshCommandResumes) {
  WheelWatchdog watchdog(kQuarter, kDeceleration, kAcceleration);
  watchdog.command(Time::seconds(1.0), {0.3, 0.4});
  EXPECT_EQ(watchdog.step(Time::seconds(1.0)).state, WatchdogState::obeying);
  for (int i = 1; i < 40; ++i) watchdog.step(Time::seconds(1.0) + kPeriod * i);
  EXPECT_NE(watchdog.step(Time::seconds(1.4)).state, WatchdogState::obeying);
  watchdog.command(Time::seconds(1.4), {0.1, 0.1});
  const WatchdogOutput output = watchdog.step(Time::seconds(1.41));
  EXPECT_EQ(output.state, WatchdogState::obeying);
  EXPECT_EQ(output.wheels, (WheelSpeeds{0.1, 0.1}));  // slower than it still was
}

// Slower by what the age of the command says, 0.04 s at 2 m/s^2, however seldom one looks; then up with 1
// m/s^2.
TEST(WheelWatchdog, ACommandThatIsLateCostsNoMoreThanItsAge) {
  WheelWatchdog watchdog(kQuarter, kDeceleration, kAcceleration);
  watchdog.command(Time::seconds(1.0), {0.5, 0.5});
  watchdog.step(Time::seconds(1.0));
  EXPECT_NEAR(watchdog.step(Time::seconds(1.29)).wheels.left, 0.42, 1e-12);
  watchdog.command(Time::seconds(1.3), {0.5, 0.5});
  EXPECT_NEAR(watchdog.step(Time::seconds(1.3)).wheels.left, 0.43, 1e-12);
  EXPECT_NEAR(watchdog.step(Time::seconds(1.34)).wheels.left, 0.47, 1e-12);
  EXPECT_EQ(watchdog.step(Time::seconds(1.38)).wheels, (WheelSpeeds{0.5, 0.5}));
  watchdog.command(Time::seconds(1.39), {0.9, 0.9});  // caught up: commands are obeyed as they are again
  EXPECT_EQ(watchdog.step(Time::seconds(1.39)).wheels, (WheelSpeeds{0.9, 0.9}));
}

TEST(WheelWatchdog, WhatIsOverruledNeedsANewCommandAndRisesFromThere) {
  WheelWatchdog watchdog(kQuarter, kDeceleration, kAcceleration);
  watchdog.command(Time::seconds(1.0), {0.5, 0.5});
  watchdog.step(Time::seconds(1.0));
  watchdog.overrule(Time::seconds(1.01), {});
  EXPECT_EQ(watchdog.step(Time::seconds(1.02)).wheels, WheelSpeeds{});
  EXPECT_EQ(watchdog.step(Time::seconds(1.02)).state, WatchdogState::stopped);
  watchdog.command(Time::seconds(1.03), {0.5, 0.25});
  EXPECT_NEAR(watchdog.step(Time::seconds(1.03)).wheels.left, 0.01, 1e-12);
  const WatchdogOutput later = watchdog.step(Time::seconds(1.13));
  EXPECT_NEAR(later.wheels.left, 0.11, 1e-12);
  EXPECT_NEAR(later.wheels.right, 0.055, 1e-12);
}

// Nobody knows how old a command is after that: it brakes until the next one, and one that was too old is not
// obeyed again.
TEST(WheelWatchdog, AClockThatGoesBackKeepsNoCommandFresh) {
  WheelWatchdog watchdog(kQuarter, kDeceleration, kAcceleration);
  watchdog.command(Time::seconds(60.0), {0.3, 0.4});
  EXPECT_EQ(watchdog.step(Time::seconds(60.0)).state, WatchdogState::obeying);
  EXPECT_EQ(watchdog.step(Time::seconds(1.0)).state, WatchdogState::stopping);
  EXPECT_NEAR(watchdog.step(Time::seconds(1.01)).wheels.right, 0.38, 1e-12);
  watchdog.command(Time::seconds(1.02), {0.3, 0.4});
  EXPECT_NEAR(watchdog.step(Time::seconds(1.02)).wheels.right, 0.39, 1e-12);
  for (int i = 0; i < 100; ++i) watchdog.step(Time::seconds(2.0) + kPeriod * i);
  for (int i = 0; i < 300; ++i) EXPECT_EQ(watchdog.step(Time{} + kPeriod * i).wheels, WheelSpeeds{});
}

TEST(WheelWatchdog, ACommandThatIsNotFiniteIsNotFresh) {
  WheelWatchdog watchdog(kQuarter, kDeceleration, kAcceleration);
  watchdog.command(Time::seconds(1.0), {0.5, 0.5});
  watchdog.step(Time::seconds(1.0));
  for (int i = 1; i <= 30; ++i) {
    EXPECT_FALSE(watchdog.command(Time::seconds(1.0) + kPeriod * i, {std::nan(""), 0.5}));
    EXPECT_FALSE(
        watchdog.command(Time::seconds(1.0) + kPeriod * i, {0.5, std::numeric_limits<double>::infinity()}));
    watchdog.step(Time::seconds(1.0) + kPeriod * i);
  }
  EXPECT_EQ(watchdog.refused(), 60U);
  EXPECT_EQ(watchdog.step(Time::seconds(1.31)).state, WatchdogState::stopping);
}

TEST(WheelWatchdog, ARevokedCommandBrakesAtTheNextCheck) {
  WheelWatchdog watchdog(kQuarter, kDeceleration, kAcceleration);
  watchdog.revoke();
  EXPECT_EQ(watchdog.step(Time::seconds(0.5)).state, WatchdogState::waiting);
  watchdog.command(Time::seconds(1.0), {0.5, 0.5});
  watchdog.step(Time::seconds(1.0));
  watchdog.revoke();
  EXPECT_NEAR(watchdog.step(Time::seconds(1.01)).wheels.left, 0.48, 1e-12);
}

TEST(WheelWatchdog, AnArcIsBrakedAlongTheArc) {
  WheelWatchdog watchdog(kQuarter, kDeceleration, kAcceleration);
  watchdog.command(Time::seconds(1.0), {0.4, 0.8});
  watchdog.step(Time::seconds(1.0));
  for (int i = 1; i < 80; ++i) {
    const WatchdogOutput output = watchdog.step(Time::seconds(1.0) + kPeriod * i);
    EXPECT_NEAR(output.wheels.left * 2.0, output.wheels.right, 1e-12);
  }
  EXPECT_EQ(watchdog.step(Time::seconds(1.9)).state, WatchdogState::stopped);
}

}  // namespace
}  // namespace bw
