// Stall and runaway. Expected times: the formula of wheel_guard.hpp, and 30 ms for a reading's age and the
// steps.
#include "components/robot_base/wheel_guard.hpp"

#include <gtest/gtest.h>

#include "components/model/random.hpp"
#include "tests/components/robot_base/guarded_base.hpp"

namespace bw {
namespace {

Robot robot_of(std::int64_t ticks, double radius) {
  Robot robot;
  robot.wheel_radius = radius;
  robot.ticks_per_revolution = ticks;
  return robot;
}
const Robot kGeneric;
const Robot kKobuki = robot_of(2578, 0.035);
const Robot kEddie = robot_of(144, 0.0762);
const Robot kCoarse = robot_of(36, 0.0762);

double formula(const Robot& robot, double v) {
  const WheelGuardOptions options;
  const double tick =
      2.0 * std::numbers::pi * robot.wheel_radius / static_cast<double>(robot.ticks_per_revolution);
  return (options.slack + 2.0 * tick) / ((1.0 - options.share) * std::abs(v) - options.tolerance);
}

struct Case {
  const char* name;
  Robot robot;
  double speed;
  double latest;  ///< [s]
};

class WheelFault : public testing::TestWithParam<Case> {};

TEST_P(WheelFault, AWheelThatStandsIsAStallInTime) {
  const auto& [name, robot, speed, latest] = GetParam();
  for (const WheelSpeeds& wish : {WheelSpeeds{speed, speed}, WheelSpeeds{-speed, speed}}) {
    GuardedBase base(robot);
    base.run(2.0, wish);
    ASSERT_EQ(base.output().wheels, wish);
    base.fault = [](const WheelSpeeds& told) { return WheelSpeeds{0.0, told.right}; };
    const auto found = base.run_until(1.0, wish, [&] { return base.output().wheels != wish; });
    ASSERT_TRUE(found);
    EXPECT_LE(*found, latest);
    EXPECT_LE(*found, formula(robot, speed) + 0.03);
    EXPECT_EQ(base.output().condition, BaseCondition::stall);
    EXPECT_TRUE(base.output().is_latched);
    EXPECT_NE(base.output().reason.find("the left wheel turns at"), std::string::npos)
        << base.output().reason;
  }
}

// The other way: the deviation is more than twice that of a stall.
TEST_P(WheelFault, AWheelThatTurnsTheOtherWayIsARunawayInTime) {
  const auto& [name, robot, speed, latest] = GetParam();
  const WheelSpeeds wish{speed, speed};
  GuardedBase base(robot);
  base.run(2.0, wish);
  base.fault = [](const WheelSpeeds& told) { return WheelSpeeds{told.left, -told.right}; };
  const auto found = base.run_until(1.0, wish, [&] { return base.output().wheels != wish; });
  ASSERT_TRUE(found);
  EXPECT_LE(*found, latest);
  // Within two ticks nobody tells standing from turning back.
  const bool is_told_apart = robot.ticks_per_revolution > 100;
  EXPECT_EQ(base.output().condition, is_told_apart ? BaseCondition::runaway : BaseCondition::stall);
}

INSTANTIATE_TEST_SUITE_P(
    Robots, WheelFault,
    testing::Values(Case{"generic_slow", kGeneric, 0.1, 0.2}, Case{"generic", kGeneric, 0.3, 0.2},
                    Case{"generic_fast", kGeneric, 1.0, 0.2}, Case{"kobuki_slow", kKobuki, 0.1, 0.2},
                    Case{"kobuki", kKobuki, 0.3, 0.2}, Case{"eddie", kEddie, 0.15, 0.2},
                    Case{"eddie_fast", kEddie, 0.6, 0.2}, Case{"coarse", kCoarse, 0.3, 0.21}),
    [](const auto& one) { return one.param.name; });

TEST(WheelGuard, WheelsThatTurnWithoutACommandAreARunawayWithin200Ms) {
  for (const double speed : {0.1, 0.3, -0.5}) {
    GuardedBase base;
    base.run(1.0, WheelSpeeds{});
    base.fault = [speed](const WheelSpeeds&) { return WheelSpeeds{speed, speed}; };
    const auto found = base.run_until(1.0, WheelSpeeds{}, [&] { return base.output().is_latched; });
    ASSERT_TRUE(found) << speed;
    EXPECT_LE(*found, 0.2) << speed;
    EXPECT_EQ(base.output().condition, BaseCondition::runaway);
  }
}

TEST(WheelGuard, AWheelThatIsFasterThanToldIsARunaway) {
  GuardedBase base;
  base.run(1.0, WheelSpeeds{0.3, 0.3});
  base.fault = [](const WheelSpeeds& told) { return WheelSpeeds{told.left * 2.0, told.right}; };
  const auto found = base.run_until(1.0, WheelSpeeds{0.3, 0.3}, [&] { return base.output().is_latched; });
  ASSERT_TRUE(found);
  EXPECT_LE(*found, 0.2);
  EXPECT_EQ(base.output().condition, BaseCondition::runaway);
}

TEST(WheelGuard, AStallWhileSettingOffIsFoundAResponseLater) {
  // 0.3 m/s from rest: 0.1 s response, 34 ms by the formula, 30 ms readings and steps; acceleration of 1
  // m/s^2 is allowed: 0.3 s.
  GuardedBase base;
  base.run(1.0, WheelSpeeds{});
  base.fault = [](const WheelSpeeds&) { return WheelSpeeds{}; };
  const auto found = base.run_until(1.0, WheelSpeeds{0.3, 0.3}, [&] { return base.output().is_latched; });
  ASSERT_TRUE(found);
  EXPECT_LE(*found, 0.1 + 0.3);
  EXPECT_EQ(base.output().condition, BaseCondition::stall);
}

// Sound bases of all sorts, driven at random within the robot's limits and stopped hard now and then: no
// alarm.
TEST(WheelGuard, SoundBasesRaiseNoAlarm) {
  constexpr std::uint64_t kSeed = 17;
  Random random(kSeed);
  int drives = 0;
  for (const Robot& robot : {kGeneric, kKobuki, kEddie, kCoarse}) {
    for (int run = 0; run < 50; ++run, ++drives) {
      GuardedBase base(robot);
      base.delay =
          static_cast<int>(random.uniform(0.0, 6.0));  // and 20 ms of a reading: within the response of 0.1 s
      base.acceleration = random.uniform(2.0, 10.0);   // at least stop_deceleration
      WheelSpeeds wish, aim;
      for (int step = 0; step < 1000; ++step) {
        if (step % 50 == 0) {
          const double v = random.uniform(-0.2, 1.0), difference = random.uniform(-0.2, 0.2);
          aim = random.uniform(0.0, 1.0) < 0.2 ? WheelSpeeds{} : WheelSpeeds{v - difference, v + difference};
        }
        const double most = random.uniform(0.0, 1.0) * 0.01;  // of 1 m/s^2
        wish.left += std::clamp(aim.left - wish.left, -most, most);
        wish.right += std::clamp(aim.right - wish.right, -most, most);
        if (step % 333 == 332) wish = {};  // a hard stop: as fast as the base can
        base.run(0.01, wish);
        ASSERT_FALSE(base.output().is_latched) << base.output().reason << " seed " << kSeed << " run " << run
                                               << " of " << robot.ticks_per_revolution << " at step " << step;
      }
    }
  }
  EXPECT_EQ(drives, 200);
}

}  // namespace
}  // namespace bw
