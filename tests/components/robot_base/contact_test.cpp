// Bumpers, cliffs and dropped wheels: back off at 0.1 m/s for at most 0.15 m, then stand until released.
#include <gtest/gtest.h>

#include "tests/components/robot_base/guarded_base.hpp"

namespace bw {
namespace {

constexpr WheelSpeeds kForwards{0.3, 0.3};

ContactReading bumper() { return {.bumper_centre = true}; }
ContactReading cliff() { return {.cliff_left = true}; }
ContactReading drop() { return {.drop_right = true}; }

GuardedBase moving() {
  GuardedBase base;
  base.run(1.0, kForwards);
  EXPECT_EQ(base.output().wheels, kForwards);
  return base;
}

struct Touch {
  const char* name;
  ContactReading contacts;
  BaseCondition end;
};

class Contact : public testing::TestWithParam<Touch> {};

TEST_P(Contact, BacksOffAndStandsUntilReleased) {
  GuardedBase base = moving();
  base.readings.contacts = GetParam().contacts;
  base.run(0.01, kForwards);
  EXPECT_EQ(base.output().wheels, (WheelSpeeds{-0.1, -0.1}));  // in the very step
  EXPECT_EQ(base.output().condition, BaseCondition::backing_off);
  // Measured where it turns round: 0.3 m/s at 4 m/s^2 takes 1 cm more.
  base.run_until(0.5, kForwards, [&] { return base.speed() <= 0.0; });
  const double farthest = base.distance();
  base.run(4.0, kForwards);
  const double back = farthest - base.distance();
  EXPECT_LE(back, 0.15);
  EXPECT_GE(back, 0.12);
  EXPECT_EQ(base.output().wheels, WheelSpeeds{});
  EXPECT_EQ(base.output().condition, GetParam().end);
  EXPECT_TRUE(base.output().is_latched);
  EXPECT_NE(base.output().reason, "");

  const auto refusal = base.guard().release();
  ASSERT_TRUE(refusal);  // it is still there
  EXPECT_EQ(*refusal, base.output().reason);
  base.readings.contacts = ContactReading{};
  base.run(1.0, kForwards);
  EXPECT_EQ(base.output().wheels, WheelSpeeds{});  // gone, and yet latched
  EXPECT_EQ(base.guard().release(), std::nullopt);
  base.run(2.5, std::nullopt);
  EXPECT_EQ(base.output().wheels, WheelSpeeds{});  // no new command
  base.run(1.0, kForwards);
  EXPECT_EQ(base.output().wheels, kForwards);
}

INSTANTIATE_TEST_SUITE_P(
    Robot, Contact,
    testing::Values(Touch{"bumper", bumper(), BaseCondition::bumper},
                    Touch{"cliff", cliff(), BaseCondition::cliff},
                    Touch{"both", {.bumper_left = true, .cliff_right = true}, BaseCondition::cliff}),
    [](const auto& touch) { return touch.param.name; });

TEST(ContactReaction, ADroppedWheelStandsAtOnce) {
  GuardedBase base = moving();
  base.readings.contacts = drop();
  base.run(0.01, kForwards);
  EXPECT_EQ(base.output().wheels, WheelSpeeds{});
  EXPECT_EQ(base.output().condition, BaseCondition::wheel_drop);
  base.readings.contacts = ContactReading{};
  base.run(1.0, kForwards);
  EXPECT_EQ(base.output().wheels, WheelSpeeds{});
}

TEST(ContactReaction, ACliffBehindIsAWheelThatDropsWhileItBacksOff) {
  GuardedBase base = moving();
  base.readings.contacts = bumper();
  base.run(0.5, kForwards);
  EXPECT_EQ(base.output().condition, BaseCondition::backing_off);
  base.readings.contacts->drop_left = true;
  base.run(0.01, kForwards);
  EXPECT_EQ(base.output().wheels, WheelSpeeds{});
  EXPECT_EQ(base.output().condition, BaseCondition::wheel_drop);
  base.readings.contacts = bumper();
  base.run(1.0, kForwards);
  EXPECT_EQ(base.output().wheels, WheelSpeeds{});  // nor does it back off again
}

TEST(ContactReaction, MoreBumpersMeanwhileMakeItNoLonger) {
  GuardedBase base = moving();
  base.readings.contacts = bumper();
  base.run_until(0.5, kForwards, [&] { return base.speed() <= 0.0; });
  const double farthest = base.distance();
  for (int i = 0; i < 40; ++i) {  // 4 s: pressed and let go, left and right
    base.readings.contacts = i % 2 == 0 ? ContactReading{} : ContactReading{.bumper_left = true};
    base.run(0.1, kForwards);
  }
  EXPECT_LE(farthest - base.distance(), 0.15);
  EXPECT_EQ(base.output().wheels, WheelSpeeds{});
}

TEST(ContactReaction, WhoStandsGoesOnStanding) {
  GuardedBase base;
  base.run(0.5, WheelSpeeds{});
  base.readings.contacts = bumper();
  base.run(2.0, WheelSpeeds{}, [&] { ASSERT_EQ(base.output().wheels, WheelSpeeds{}); });
  EXPECT_EQ(base.output().condition, BaseCondition::bumper);
}

TEST(ContactReaction, AShortTouchIsATouch) {
  GuardedBase base = moving();
  base.readings.contacts = bumper();
  base.run(0.01, kForwards);
  base.readings.contacts = ContactReading{};
  base.run(4.0, kForwards);
  EXPECT_EQ(base.output().condition, BaseCondition::bumper);
  EXPECT_EQ(base.output().wheels, WheelSpeeds{});
}

// A touch of 0.1 s that may let go by itself: it backs off 0.15 m all the same, 1.5 s long, and then stands
// for the pause.
TEST(ContactReaction, ATouchThatIsOverByItselfLastsUntilItHasBackedOff) {
  for (const ContactReading& contacts : {bumper(), cliff()}) {
    GuardedBase base({},
                     {.restart = {.cliff = Restart::by_itself, .bumper = Restart::by_itself, .pause = 0.5}});
    base.run(1.0, kForwards);
    base.readings.contacts = contacts;
    base.run(0.1, kForwards);
    base.readings.contacts = ContactReading{};
    base.run(1.0, kForwards, [&] {
      ASSERT_EQ(base.output().condition, BaseCondition::backing_off);
      ASSERT_NE(base.output().reason, "");
    });
    ASSERT_TRUE(base.run_until(1.0, kForwards, [&] { return base.output().wheels == WheelSpeeds{}; }));
    base.run(0.5, kForwards, [&] { ASSERT_EQ(base.output().wheels, WheelSpeeds{}); });
    base.run(1.0, kForwards);
    EXPECT_EQ(base.output().wheels, kForwards);
  }
}

TEST(ContactReaction, AnEmergencyStopEndsBackingOff) {
  GuardedBase base = moving();
  base.readings.contacts = bumper();
  base.run(0.5, kForwards);
  base.guard().set_emergency_stop(true);
  base.run(0.01, kForwards);
  EXPECT_EQ(base.output().wheels, WheelSpeeds{});
  EXPECT_EQ(base.output().condition, BaseCondition::emergency_stop);
}

TEST(ContactReaction, EndsInTimeThoughWheelsDoNotTurn) {
  ContactReaction reaction({}, 2.0);
  const Time begin = Time::seconds(5.0);
  reaction.touch(begin, 1.0, bumper(), true);
  for (int i = 0; i < 300; ++i) {
    ASSERT_TRUE(reaction.step(begin + Duration::milliseconds(10) * i, 1.0, bumper())) << i;
  }
  EXPECT_FALSE(reaction.step(begin + Duration::milliseconds(3000), 1.0, bumper()));
  EXPECT_FALSE(reaction.is_backing_off());
}

TEST(ContactReaction, CanBeLeftOut) {
  GuardedBase base({}, {.contacts = {.back_off = false}});
  base.run(1.0, kForwards);
  base.readings.contacts = bumper();
  base.run(0.01, kForwards);
  EXPECT_EQ(base.output().wheels, WheelSpeeds{});
  EXPECT_EQ(base.output().condition, BaseCondition::bumper);
}

}  // namespace
}  // namespace bw
