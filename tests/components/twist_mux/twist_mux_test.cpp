// Sources with the priorities 100 (a hand, time-out 0.2 s), 90 (the same, stamped), 50 (time-out 0.25 s) and
// 10 (time-out 0.5 s).
#include "components/twist_mux/twist_mux.hpp"

#include <cstdint>
#include <limits>

#include <gmock/gmock.h>

#include "components/twist_mux/goal_in_hand.hpp"

namespace bw {
namespace {

constexpr std::size_t kTeleop = 0, kStamped = 1, kBehavior = 2, kNav = 3;
const Twist2 kAhead{0.5, 0.1}, kBack{-0.2, 0.0}, kRotation{0.0, 1.0};

Time at(double seconds) { return Time::seconds(1000.0 + seconds); }
TwistMux mux() { return TwistMux(TwistMuxOptions{}); }

TEST(TwistMux, PassesTheCommandsOfTheOneThatSpeaksAsTheyAre) {
  TwistMux m = mux();
  EXPECT_EQ(m.command(at(0.0), kNav, kAhead), kAhead);
  EXPECT_EQ(m.command(at(0.1), kNav, Twist2{}), Twist2{});
  EXPECT_EQ(m.active(at(0.2)), kNav);
  EXPECT_EQ(m.active(at(0.7)), std::nullopt);
}

// Before, the planner went on 1 s after the last key: a person who had driven the robot by hand and let go
// was surprised.
TEST(TwistMux, WhomAHandTookOverFromIsNotHeardAgainBeforeARelease) {
  TwistMux m = mux();
  m.command(at(0.0), kNav, kAhead);
  EXPECT_FALSE(m.is_interrupted());
  EXPECT_EQ(m.command(at(0.05), kTeleop, kBack), kBack);
  EXPECT_TRUE(m.is_interrupted());
  for (int i = 2; i <= 2001; ++i)
    EXPECT_EQ(m.command(at(0.05 * i), kNav, kAhead), std::nullopt) << i;  // 100 s
  EXPECT_EQ(m.command(at(101.0), kBehavior, kRotation), std::nullopt);
  // Silent for 0.2 s and a hand is nobody who outranks: from 0.25 s on, so from i = 6, it is the
  // interruption.
  EXPECT_EQ(m.count(kNav).outranked, 4U);
  EXPECT_EQ(m.count(kNav).interrupted, 1996U);
  m.release();
  EXPECT_EQ(m.command(at(101.1), kNav, kAhead), kAhead);
}

TEST(TwistMux, AHandInterruptsWhoeverWantsToDriveMeanwhile) {
  TwistMux m = mux();
  m.command(at(0.0), kTeleop, kBack);
  EXPECT_FALSE(m.is_interrupted());  // nobody is there
  EXPECT_EQ(m.command(at(0.1), kNav, Twist2{}), std::nullopt);
  EXPECT_FALSE(m.is_interrupted());
  EXPECT_EQ(m.command(at(0.15), kNav, kAhead), std::nullopt);
  EXPECT_TRUE(m.is_interrupted());
  EXPECT_EQ(m.command(at(5.0), kNav, kAhead), std::nullopt);
}

// A planner that says nothing at this moment, as between two attempts, has its goal all the same.
TEST(TwistMux, AHandInterruptsAGoalThoughNobodyDrives) {
  TwistMux m = mux();
  m.set_goal(true);
  EXPECT_EQ(m.command(at(0.0), kStamped, Twist2{}), Twist2{});
  EXPECT_TRUE(m.is_interrupted());
  EXPECT_EQ(m.command(at(5.0), kNav, kAhead), std::nullopt);
  EXPECT_EQ(m.command(at(5.0), kTeleop, kBack), kBack);  // a hand is never interrupted
  EXPECT_EQ(m.command(at(6.0), kStamped, kBack), kBack);
}

TEST(TwistMux, WithoutAnybodyToInterruptTheNextGoalIsDrivenAsSoonAsTheHandIsSilent) {
  TwistMux m = mux();
  m.command(at(0.0), kTeleop, kBack);
  EXPECT_EQ(m.command(at(0.21), kNav, kAhead), kAhead);
}

TEST(TwistMux, ABehaviorInterruptsNobody) {
  TwistMux m = mux();
  m.set_goal(true);
  m.command(at(0.0), kNav, kAhead);
  m.command(at(0.1), kBehavior, kRotation);
  EXPECT_FALSE(m.is_interrupted());
}

// A behavior ends with zero, and then says nothing: the planner's next command counts once its time-out is
// over, and no zero is added.
TEST(TwistMux, ABehaviorGoesBeforeThePlannerAndLeavesItTheRobotAQuarterOfASecondAfterItsEnd) {
  TwistMux m = mux();
  m.command(at(0.0), kNav, kAhead);
  EXPECT_EQ(m.command(at(0.05), kBehavior, kRotation), kRotation);
  EXPECT_EQ(m.command(at(0.1), kNav, kAhead), std::nullopt);
  EXPECT_EQ(m.command(at(0.15), kBehavior, Twist2{}), Twist2{});
  EXPECT_EQ(m.command(at(0.4), kNav, kAhead), std::nullopt);
  EXPECT_EQ(m.check(at(0.41)), std::nullopt);
  EXPECT_EQ(m.command(at(0.41), kNav, kAhead), kAhead);
  // A hand goes before both.
  EXPECT_EQ(m.command(at(0.5), kTeleop, kBack), kBack);
  EXPECT_EQ(m.command(at(0.55), kBehavior, kRotation), std::nullopt);
}

TEST(TwistMux, SilenceIsAZeroOnceAfterTheTimeOut) {
  TwistMux m = mux();
  m.command(at(0.0), kTeleop, kAhead);
  EXPECT_EQ(m.check(at(0.2)), std::nullopt);
  EXPECT_EQ(m.check(at(0.201)), Twist2{});
  EXPECT_EQ(m.check(at(0.3)), std::nullopt);
  EXPECT_EQ(m.active(at(0.3)), std::nullopt);
}

TEST(TwistMux, WhoEndedAtRestLeavesNothingToStop) {
  TwistMux m = mux();
  m.command(at(0.0), kNav, kAhead);
  m.command(at(0.1), kNav, Twist2{});
  EXPECT_EQ(m.check(at(5.0)), std::nullopt);
  EXPECT_EQ(mux().check(at(0.0)), std::nullopt);
}

TEST(TwistMux, TheTimeOutThatCountsIsThatOfTheOneWhoDrives) {
  TwistMux m = mux();
  m.command(at(0.0), kTeleop, kAhead);
  m.command(at(2.0), kNav, kAhead);  // it began after the hand
  EXPECT_EQ(m.check(at(2.5)), std::nullopt);
  EXPECT_EQ(m.check(at(2.501)), Twist2{});
}

// A simulation begins again: what was heard at 60 s is neither fresh at 1 s nor outranks anybody for the next
// 59 s.
TEST(TwistMux, AClockThatGoesBackForgetsWhoSpoke) {
  TwistMux m = mux();
  m.command(at(60.0), kTeleop, kAhead);
  EXPECT_EQ(m.active(at(1.0)), std::nullopt);
  EXPECT_EQ(m.check(at(1.0)), Twist2{});
  EXPECT_EQ(m.command(at(1.0), kNav, kAhead), kAhead);
  // Nor once the new time has come to where it was heard.
  EXPECT_EQ(m.command(at(60.0), kNav, kAhead), kAhead);
  EXPECT_EQ(m.active(at(60.0)), kNav);
}

TEST(TwistMux, WhatIsNoNumberIsRefusedAndTakesNothingOver) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  TwistMux m = mux();
  m.command(at(0.0), kNav, kAhead);
  EXPECT_EQ(m.command(at(0.1), kTeleop, {kNan, 0.0}), std::nullopt);
  EXPECT_EQ(m.command(at(0.1), kTeleop, {0.0, -kInfinity}), std::nullopt);
  EXPECT_EQ(m.count(kTeleop).not_finite, 2U);
  EXPECT_EQ(m.command(at(0.1), kNav, kRotation), kRotation);
  // Of the one who drives it is a stop, once.
  EXPECT_EQ(m.command(at(0.2), kNav, {kNan, 0.0}), Twist2{});
  EXPECT_EQ(m.command(at(0.3), kNav, {kNan, 0.0}), std::nullopt);
  EXPECT_EQ(m.command(at(0.4), kNav, kAhead), kAhead);
}

TEST(TwistMux, AStampOfTheOwnClockThatIsTooOldOrOfTheFutureIsNoCommand) {
  TwistMux m = mux();
  for (const double age : {0.501, 1.0, 10.1, 3600.0, -0.1, -3600.0})
    EXPECT_EQ(m.command(at(0.0), kStamped, kAhead, at(-age)), std::nullopt) << age;
  EXPECT_EQ(m.count(kStamped).stale, 6U);
  EXPECT_EQ(m.active(at(0.0)), std::nullopt);
  EXPECT_EQ(m.command(at(3600.0), kStamped, kAhead, at(3599.5)), kAhead);
  EXPECT_EQ(m.command(at(3600.1), kStamped, kAhead, Time{}), kAhead);  // without a stamp nothing is known
}

/// A hand at 20 Hz whose clock is `ahead` of ours [s]; how many of its commands went on.
int drive(TwistMux& m, double from, double to, double ahead, double delay, std::uint8_t writer = 1) {
  int passed = 0;
  for (int i = 0; from + 0.05 * i < to; ++i) {
    const double t = from + 0.05 * i;
    passed +=
        m.command(at(t + delay), kStamped, kAhead, at(t + ahead), {.writer = {writer}, .is_own_clock = false})
            .has_value();
  }
  return passed;
}

TEST(TwistMux, AHandWhoseClockIsAnHourOffDrivesAfterASecondAndIsRefusedWhenItIsLate) {
  for (const double ahead : {-3600.0, 3600.0, 1e9}) {
    TwistMux m = mux();
    EXPECT_EQ(drive(m, 0.0, 1.0, ahead, 0.02), 0);
    EXPECT_EQ(drive(m, 1.0, 3.0, ahead, 0.02), 40);
    EXPECT_EQ(drive(m, 3.0, 4.0, ahead, 1.0), 0);    // held back by a second
    EXPECT_EQ(drive(m, 5.0, 7.0, ahead, 0.02), 40);  // a pause is no reason to prove it again
    // Its clock is set: it stands for a second.
    EXPECT_EQ(drive(m, 8.0, 8.999, ahead - 1800.003, 0.02), 0);
    EXPECT_GE(drive(m, 9.0, 11.0, ahead - 1800.003, 0.02), 39);
    EXPECT_EQ(m.count(kStamped).steps, 1U);
  }
}

TEST(TwistMux, TwoHandsWithClocksOfTheirOwn) {
  TwistMux m = mux();
  drive(m, 0.0, 2.0, 500.0, 0.02, 1);
  drive(m, 2.0, 4.0, -500.0, 0.02, 2);
  EXPECT_EQ(drive(m, 4.0, 5.0, 500.0, 0.02, 1), 20);
  EXPECT_EQ(drive(m, 5.0, 6.0, -500.0, 0.02, 2), 20);
}

// Row 13 of the faults: a stop, and then what was said before it.
TEST(TwistMux, WhatWasOvertakenIsNotObeyed) {
  for (const bool is_own : {true, false}) {
    const StampSource writer{.is_own_clock = is_own};
    TwistMux m = mux();
    for (int i = 0; i < 40; ++i) m.command(at(0.05 * i), kStamped, kAhead, at(0.05 * i), writer);
    EXPECT_EQ(m.command(at(2.05), kStamped, Twist2{}, at(2.05), writer), Twist2{});
    EXPECT_EQ(m.command(at(2.06), kStamped, kAhead, at(2.0), writer), std::nullopt);
    EXPECT_EQ(m.command(at(2.07), kStamped, kAhead, at(0.05), writer), std::nullopt);
    EXPECT_EQ(m.command(at(2.08), kStamped, Twist2{}, at(2.05), writer), Twist2{});  // twice
    EXPECT_EQ(m.check(at(3.0)), std::nullopt);
  }
}

TEST(TwistMux, AThousandOfOneSourceBetweenTwoOfAHigherOneChangeNothing) {
  TwistMux m = mux();
  for (int i = 0; i < 1000; ++i) {
    const double t = 1e-3 * i;
    if (i % 50 == 0) {
      EXPECT_EQ(m.command(at(t), kTeleop, kBack), kBack);
    }
    EXPECT_EQ(m.command(at(t), kNav, kAhead), std::nullopt);
    EXPECT_EQ(m.check(at(t)), std::nullopt);
  }
}

GoalStatus final_one(int i) { return i == 0 ? GoalStatus::aborted : GoalStatus::canceled; }

TEST(GoalInHand, IsOverWithItsEndOrAnotherOne) {
  GoalInHand goal;
  EXPECT_TRUE(goal.see(1, GoalStatus::accepted, 0));
  EXPECT_FALSE(goal.see(1, GoalStatus::executing, 0));
  EXPECT_TRUE(goal.is_in_hand());
  EXPECT_FALSE(goal.see(2, GoalStatus::aborted, 0));  // one that could not be taken
  EXPECT_TRUE(goal.is_in_hand());
  EXPECT_TRUE(goal.see(3, GoalStatus::accepted, 0));
  EXPECT_FALSE(goal.see(1, GoalStatus::aborted, 0));  // preempted, and told after its successor
  EXPECT_TRUE(goal.is_in_hand());
  for (int i = 0; i < 2; ++i) EXPECT_TRUE(goal.see(3, final_one(i), 0));
  EXPECT_FALSE(goal.is_in_hand());
}

TEST(GoalInHand, WhatFollowsInAListGoesOn) {
  GoalInHand goal;
  goal.see(1, GoalStatus::accepted, 2);
  EXPECT_FALSE(goal.see(1, GoalStatus::succeeded, 2));
  EXPECT_TRUE(goal.is_in_hand());
  EXPECT_FALSE(goal.see(2, GoalStatus::accepted, 1));
  EXPECT_FALSE(goal.see(2, GoalStatus::executing, 1));
  EXPECT_TRUE(goal.see(2, GoalStatus::canceled, 0));  // the list was given up
  EXPECT_FALSE(goal.is_in_hand());
}

// A navigator that begins anew counts from 1 again.
TEST(GoalInHand, AnotherNavigatorsGoalIsAnother) {
  GoalInHand goal;
  goal.see(7, GoalStatus::accepted, 0);
  EXPECT_TRUE(goal.see(1, GoalStatus::accepted, 0));
}

TEST(TwistMuxOptions, PrioritiesAndTopicsAreDeclaredOnce) {
  TwistMuxOptions options;
  EXPECT_EQ(options.violated_rule(), std::nullopt);
  options.sources[1].priority = 100;
  EXPECT_THAT(*options.violated_rule(),
              testing::HasSubstr("cmd_vel_teleop and cmd_vel_teleop_stamped have the same"));
  options.sources[1] = options.sources[0];
  options.sources[1].priority = 5;
  EXPECT_THAT(*options.violated_rule(), testing::HasSubstr("cmd_vel_teleop is there twice"));
  options.sources.clear();
  EXPECT_TRUE(options.violated_rule().has_value());
}

}  // namespace
}  // namespace bw
