// The cable, the emergency stop, faults, battery and charger, and what all of them have in common: what
// interrupted a motion takes a release, and a command that arrived before the base may drive again moves
// nothing.
#include "components/robot_base/base_guard.hpp"

#include <gtest/gtest.h>

#include "components/model/random.hpp"
#include "tests/components/robot_base/guarded_base.hpp"

namespace bw {
namespace {

constexpr WheelSpeeds kAhead{0.4, 0.4};

GuardedBase driving() {
  GuardedBase base;
  base.run(1.0, kAhead);
  EXPECT_EQ(base.output().wheels, kAhead);
  EXPECT_EQ(base.output().condition, BaseCondition::driving);
  EXPECT_EQ(base.output().reason, "");
  return base;
}

/// From 0.4 m/s at 2 m/s^2: 0.2 s, in steps of 0.02 m/s.
void expect_ramp(GuardedBase& base) {
  double before = base.output().wheels.left;
  for (int i = 0; i < 25; ++i) {
    base.run(0.01, kAhead);
    const double v = base.output().wheels.left;
    ASSERT_LE(v, before);
    ASSERT_GE(v, before - 0.02 - 1e-12);
    before = v;
  }
  EXPECT_EQ(before, 0.0);
}

/// A release while commands go on: 2 s in which nothing moves (`restart.pause`) and which are told, then up
/// with 1 m/s^2.
void expect_set_off_after_a_release(GuardedBase& base) {
  ASSERT_EQ(base.output().wheels, WheelSpeeds{});
  ASSERT_EQ(base.guard().release(), std::nullopt);
  double seconds = 2.0;
  base.run(2.0, kAhead, [&] {
    ASSERT_EQ(base.output().wheels, WheelSpeeds{});
    ASSERT_EQ(base.output().condition, BaseCondition::waiting);
    ASSERT_EQ(base.output().reason, seconds > 1.005 ? "drives on in 2 s" : "drives on in 1 s");
    seconds -= 0.01;
  });
  base.run(0.1, kAhead);
  EXPECT_GT(base.output().wheels.left, 0.0);
  EXPECT_LE(base.output().wheels.left, 0.1 + 1e-9);
  EXPECT_EQ(base.output().reason, "");
  base.run(0.5, kAhead);
  EXPECT_EQ(base.output().wheels, kAhead);
}

TEST(BaseGuard, NothingDrivesBeforeTheBaseIsHeard) {
  GuardedBase base;
  base.is_silent = true;
  base.run(0.99, kAhead, [&] { ASSERT_EQ(base.output().wheels, WheelSpeeds{}); });
  EXPECT_EQ(base.output().condition, BaseCondition::waiting);
  base.run(0.1, kAhead);
  EXPECT_EQ(base.output().condition, BaseCondition::link);
  EXPECT_FALSE(base.output().is_latched);
  EXPECT_EQ(base.output().reason, "the base has not told its wheels yet");
  base.is_silent = false;
  base.run(0.1, kAhead);
  EXPECT_GT(base.output().wheels.left, 0.0);
  EXPECT_LE(base.output().wheels.left, 0.1 + 1e-9);  // 1 m/s^2: who commands it has not waited
}

TEST(BaseGuard, SilenceIsARampWithin300MsAndTakesARelease) {
  GuardedBase base = driving();
  base.is_silent = true;
  const auto found = base.run_until(1.0, kAhead, [&] { return base.output().wheels != kAhead; });
  ASSERT_TRUE(found);
  EXPECT_NEAR(*found, 0.2, 0.021);  // `silence`, from the last counts
  EXPECT_EQ(base.output().condition, BaseCondition::link);
  EXPECT_EQ(base.output().reason, "the base is silent");
  expect_ramp(base);
  base.run(2.0, kAhead);
  base.is_silent = false;
  base.run(5.0, kAhead, [&] { ASSERT_EQ(base.output().wheels, WheelSpeeds{}); });
  EXPECT_EQ(base.output().condition, BaseCondition::link);
  EXPECT_TRUE(base.output().is_latched);
  expect_set_off_after_a_release(base);
}

// A base process that was killed while somebody drove: the next one does not go on by itself.
TEST(BaseGuard, WhoTakesOverFromOneThatWasKilledTakesAReleaseWhereSomebodyDrove) {
  GuardedBase base;
  base.guard().takes_over();
  base.run(0.3, std::nullopt);  // until commands are heard
  base.run(5.0, kAhead, [&] { ASSERT_EQ(base.output().wheels, WheelSpeeds{}); });
  EXPECT_EQ(base.output().condition, BaseCondition::link);
  EXPECT_TRUE(base.output().is_latched);
  EXPECT_EQ(base.output().reason, "the process of the base ended and was started again");
  expect_set_off_after_a_release(base);
}

// While nobody does, it is ready after twice the pause of 2 s: its own, and that of all that is over.
TEST(BaseGuard, WhoTakesOverFromOneThatWasKilledIsReadyWhereNobodyDrove) {
  GuardedBase base;
  base.guard().takes_over();
  base.run(4.1, std::nullopt, [&] { ASSERT_FALSE(base.output().is_latched); });
  base.run(0.2, kAhead);
  EXPECT_GT(base.output().wheels.left, 0.0);
}

TEST(BaseGuard, ACableThatIsPulledIsARampAtOnce) {
  GuardedBase base = driving();
  base.readings.link = {.is_open = false, .device = "/dev/base", .fault = "unplugged", .openings = 1};
  base.run(0.01, kAhead);
  EXPECT_LT(base.output().wheels.left, kAhead.left);
  EXPECT_EQ(base.output().reason, "/dev/base is not connected: unplugged");
  expect_ramp(base);
}

TEST(BaseGuard, ADeviceThatWasOpenedAnewHearsAStopFirst) {
  GuardedBase base;
  base.readings.link = {.is_open = true, .device = "/dev/base", .openings = 1};
  base.run(1.0, kAhead);
  ASSERT_EQ(base.output().wheels, kAhead);
  base.readings.link.openings = 2;  // too short a gap to be seen closed
  base.run(0.01, kAhead);
  EXPECT_EQ(base.output().wheels, WheelSpeeds{});
  EXPECT_EQ(base.output().condition, BaseCondition::link);
  EXPECT_EQ(base.output().reason, "/dev/base was opened anew");
  base.run(5.0, kAhead, [&] { ASSERT_EQ(base.output().wheels, WheelSpeeds{}); });
  expect_set_off_after_a_release(base);
}

// Drivers say that it is open when the base has answered, so that its first counts come with the first
// opening.
TEST(BaseGuard, TheFirstOpeningIsNoneAnew) {
  GuardedBase base;
  base.readings.link = {
      .is_open = false, .is_opening = true, .device = "/dev/base", .fault = "not opened yet"};
  base.is_silent = true;
  base.run(2.0, std::nullopt, [&] { ASSERT_EQ(base.output().reason, ""); });
  base.readings.link = {.is_open = true, .device = "/dev/base", .openings = 1};
  base.is_silent = false;
  base.run(1.0, std::nullopt, [&] { ASSERT_EQ(base.output().reason, ""); });
}

// The port of a busy machine takes half a second to open, while somebody commands already; the first poll of
// the open port has counts. From then on commands have `silence`, 0.2 s, to get through.
TEST(BaseGuard, CommandsBeforeTheBaseWasHeardAreNoLostBase) {
  GuardedBase base;
  base.readings.link = {.is_open = false, .is_opening = true, .device = "cable"};
  base.is_silent = base.is_deaf = true;
  base.run(0.5, kAhead);
  base.readings.link = {.is_open = true, .device = "cable", .openings = 1};
  base.is_silent = base.is_deaf = false;
  base.run(1.0, kAhead, [&] {
    ASSERT_NE(base.output().condition, BaseCondition::link) << base.seconds() << base.output().reason;
  });
  EXPECT_NEAR(base.speed(), kAhead.left, 0.01);
}

TEST(BaseGuard, CommandsThatDoNotGetThroughAreALostBase) {
  GuardedBase base = driving();
  base.is_deaf = true;
  const auto found = base.run_until(1.0, kAhead, [&] { return base.output().wheels != kAhead; });
  ASSERT_TRUE(found);
  EXPECT_NEAR(*found, 0.2, 0.021);
  EXPECT_EQ(base.output().reason, "commands do not get through to the base");
}

TEST(BaseGuard, WhatTheBaseDroveUnheardIsNoRunaway) {
  GuardedBase base = driving();
  base.is_silent = true;
  base.fault = [](const WheelSpeeds&) { return kAhead; };  // a firmware that goes on
  base.run(1.0, kAhead);
  base.is_silent = false;
  base.fault = {};
  base.run(2.0, kAhead,
           [&] { ASSERT_EQ(base.output().condition, BaseCondition::link) << base.output().reason; });
  expect_set_off_after_a_release(base);
}

TEST(BaseGuard, AnEmergencyStopIsARampAndNeedsAReleaseAfterItIsOver) {
  GuardedBase base = driving();
  base.guard().set_emergency_stop(true);
  expect_ramp(base);
  EXPECT_EQ(base.output().condition, BaseCondition::emergency_stop);
  EXPECT_TRUE(base.output().is_latched);
  EXPECT_EQ(base.guard().release(), "the emergency stop is pressed");
  base.guard().set_emergency_stop(false);
  base.run(5.0, kAhead, [&] { ASSERT_EQ(base.output().wheels, WheelSpeeds{}); });
  base.run(0.3, std::nullopt);
  EXPECT_EQ(base.guard().release(), std::nullopt);
  base.run(3.0, std::nullopt, [&] {
    ASSERT_EQ(base.output().wheels, WheelSpeeds{});
    ASSERT_EQ(base.output().reason, "");  // nobody wants to drive on
  });
  base.run(1.0, kAhead);
  EXPECT_EQ(base.output().wheels, kAhead);
}

TEST(BaseGuard, AReleaseOfNothingChangesNothing) {
  GuardedBase base = driving();
  EXPECT_EQ(base.guard().release(), std::nullopt);
  base.run(0.5, kAhead, [&] { ASSERT_EQ(base.output().wheels, kAhead); });
}

// Whoever freed the robot sees that it is about to drive, and a second stop needs a second release and all of
// the pause.
TEST(BaseGuard, AStopWithinThePauseCancelsIt) {
  GuardedBase base = driving();
  base.guard().set_emergency_stop(true);
  expect_ramp(base);
  base.guard().set_emergency_stop(false);
  EXPECT_EQ(base.guard().release(), std::nullopt);
  base.run(1.9, kAhead, [&] { ASSERT_EQ(base.output().wheels, WheelSpeeds{}); });
  base.guard().set_emergency_stop(true);
  base.run(0.1, kAhead);
  base.guard().set_emergency_stop(false);
  base.run(5.0, kAhead, [&] { ASSERT_EQ(base.output().wheels, WheelSpeeds{}); });
  expect_set_off_after_a_release(base);
}

TEST(BaseGuard, AClockThatJumpsMakesThePauseNoShorter) {
  GuardedBase base = driving();
  base.guard().set_emergency_stop(true);
  expect_ramp(base);
  base.guard().set_emergency_stop(false);
  EXPECT_EQ(base.guard().release(), std::nullopt);
  base.run(0.01, std::nullopt);
  base.step_clock(3600.0);
  base.run(1.8, std::nullopt);
  base.step_clock(-7200.0);
  base.run(0.1, kAhead, [&] { ASSERT_EQ(base.output().wheels, WheelSpeeds{}); });
}

TEST(BaseGuard, AFaultOfTheDeviceIsARampAndTakesARelease) {
  GuardedBase base = driving();
  base.readings.fault = "ticks jumped";
  expect_ramp(base);
  EXPECT_EQ(base.output().condition, BaseCondition::device);
  EXPECT_TRUE(base.output().is_latched);
  EXPECT_EQ(base.output().reason, "ticks jumped");
  base.readings.fault.clear();
  base.run(5.0, kAhead, [&] { ASSERT_EQ(base.output().wheels, WheelSpeeds{}); });
  expect_set_off_after_a_release(base);
}

TEST(BaseGuard, OvercurrentIsAFaultUntilItIsToldToBeOver) {
  GuardedBase base = driving();
  base.readings.currents = CurrentReading{.left = 4.0, .is_over_left = true};
  base.run(0.01, kAhead);
  EXPECT_EQ(base.output().reason, "overcurrent: left");
  base.readings.currents.reset();
  base.run(2.0, kAhead);
  EXPECT_EQ(base.guard().release(), "overcurrent: left");
  base.readings.currents = CurrentReading{};
  base.run(2.0, kAhead);
  expect_set_off_after_a_release(base);
}

TEST(BaseGuard, RestartsAsConfigured) {
  GuardedBase base({},
                   {.restart = {.bumper = Restart::by_itself, .device = Restart::released, .pause = 1.0}});
  base.run(1.0, kAhead);
  base.readings.fault = "ticks jumped";
  base.run(0.5, kAhead);
  base.readings.fault.clear();
  base.run(5.0, kAhead);
  EXPECT_TRUE(base.output().is_latched);
  EXPECT_EQ(base.guard().release(), std::nullopt);
  base.run(2.0, kAhead);
  ASSERT_EQ(base.output().wheels, kAhead);
  base.readings.contacts = ContactReading{.bumper_left = true};
  base.run(3.0, kAhead);
  EXPECT_EQ(base.output().condition, BaseCondition::bumper);
  EXPECT_FALSE(base.output().is_latched);
  base.readings.contacts = ContactReading{};
  base.run(0.98, kAhead, [&] { ASSERT_EQ(base.output().wheels, WheelSpeeds{}); });
  base.run(1.0, kAhead);
  EXPECT_EQ(base.output().wheels, kAhead);
}

TEST(BaseGuard, AnEmptyBatteryStopsAfterAWhile) {
  GuardedBase base({}, {.battery = {.low = 14.0, .empty = 13.2, .lasting = 3.0}});
  const auto at = [&](double voltage, double seconds) {
    base.readings.battery = BatteryReading{.voltage = voltage};
    base.run(seconds, kAhead);
  };
  at(15.0, 1.0);
  at(13.0, 2.9);  // a dip
  EXPECT_EQ(base.guard().battery(), BatteryLevel::good);
  at(13.5, 3.1);
  EXPECT_EQ(base.guard().battery(), BatteryLevel::low);
  EXPECT_EQ(base.output().wheels, kAhead);
  at(13.0, 3.3);
  EXPECT_EQ(base.output().wheels, WheelSpeeds{});
  EXPECT_EQ(base.output().condition, BaseCondition::battery);
  at(13.5, 4.0);  // it recovers without a load, and is not full for that
  EXPECT_EQ(base.guard().release(), "the battery is empty");
  at(15.0, 3.1);
  EXPECT_EQ(base.guard().battery(), BatteryLevel::good);
  expect_set_off_after_a_release(base);
}

// What nobody was interrupted by is over when it is over: charged over night, cable in again, fault gone.
TEST(BaseGuard, WhatInterruptedNobodyNeedsNoRelease) {
  GuardedBase base;
  base.run(1.0, WheelSpeeds{});
  base.readings.battery = BatteryReading{.voltage = 15.0, .is_plugged = true};
  base.run(1.0, WheelSpeeds{});
  EXPECT_EQ(base.output().condition, BaseCondition::charging);
  EXPECT_FALSE(base.output().is_latched);
  base.readings.battery->is_plugged = false;
  base.run(2.5, WheelSpeeds{});
  EXPECT_EQ(base.output().reason, "");
  base.is_silent = true;
  base.run(1.0, std::nullopt);
  EXPECT_EQ(base.output().condition, BaseCondition::link);
  base.is_silent = false;
  base.run(1.0, std::nullopt);
  base.run(1.0, kAhead, [&] { ASSERT_EQ(base.output().wheels, WheelSpeeds{}); });  // 2 s after it was over
  base.run(1.0, kAhead);
  EXPECT_EQ(base.output().wheels, kAhead);
}

// However short the wish was: a goal that came while it charged, a key that was pressed at it.
TEST(BaseGuard, OneCommandWhileTheCauseLastsIsEnoughToLatchIt) {
  GuardedBase base;
  base.run(1.0, WheelSpeeds{});
  base.readings.battery = BatteryReading{.voltage = 15.0, .is_plugged = true};
  base.run(1.0, WheelSpeeds{});
  base.run(0.02, kAhead);
  base.run(1.0, WheelSpeeds{});
  base.readings.battery->is_plugged = false;
  base.run(5.0, kAhead, [&] { ASSERT_EQ(base.output().wheels, WheelSpeeds{}); });
  EXPECT_TRUE(base.output().is_latched);
  EXPECT_EQ(base.output().reason, "the charger is connected");
  expect_set_off_after_a_release(base);
}

TEST(BaseGuard, NobodyDrivesAtTheCharger) {
  GuardedBase base;
  base.readings.battery = BatteryReading{.voltage = 15.0, .is_charging = true, .is_plugged = true};
  base.run(1.0, kAhead, [&] { ASSERT_EQ(base.output().wheels, WheelSpeeds{}); });
  EXPECT_EQ(base.output().condition, BaseCondition::charging);
  base.readings.battery->is_charging = false;  // full
  base.run(1.0, kAhead, [&] { ASSERT_EQ(base.output().wheels, WheelSpeeds{}); });
  EXPECT_EQ(base.guard().release(), "the charger is connected");
  base.readings.battery->is_plugged = false;
  base.run(5.0, kAhead, [&] { ASSERT_EQ(base.output().wheels, WheelSpeeds{}); });
  expect_set_off_after_a_release(base);
}

// Whatever comes in whatever order: what is latched moves nothing until it is released, and nothing is faster
// than the command or backing off.
TEST(BaseGuard, NothingMovesWhileItIsLatchedInAnyOrderOfEvents) {
  constexpr std::uint64_t kSeed = 23;
  Random random(kSeed);
  int stops = 0;
  for (int run = 0; run < 100; ++run) {
    GuardedBase base;
    base.run(0.5, kAhead);
    int latched = 0;  // [steps] since it was latched and did not back off
    for (int step = 0; step < 2000; ++step) {
      const double dice = random.uniform(0.0, 1.0);
      if (dice < 0.002) base.readings.contacts = ContactReading{.bumper_left = true};
      if (dice > 0.002 && dice < 0.003) base.readings.contacts = ContactReading{.drop_left = true};
      if (dice > 0.003 && dice < 0.010) base.readings.contacts = ContactReading{};
      if (dice > 0.010 && dice < 0.011) base.readings.link.openings++;
      if (dice > 0.011 && dice < 0.015) base.is_silent = !base.is_silent;
      if (dice > 0.015 && dice < 0.018) base.guard().set_emergency_stop(dice < 0.016);
      if (dice > 0.018 && dice < 0.022 && !base.guard().release()) latched = 0;
      base.run(0.01, kAhead);
      const BaseOutput& output = base.output();
      const bool is_still = output.is_latched && output.condition != BaseCondition::backing_off;
      latched = is_still ? latched + 1 : 0;
      stops += latched == 1 ? 1 : 0;
      ASSERT_LE(output.wheels.left, kAhead.left);
      ASSERT_GE(output.wheels.left, -0.1);
      if (latched > 21) {  // 0.4 m/s at 2 m/s^2
        ASSERT_EQ(output.wheels, WheelSpeeds{}) << "seed " << kSeed << " run " << run << " step " << step;
      }
    }
  }
  EXPECT_GT(stops, 100);
}

}  // namespace
}  // namespace bw
