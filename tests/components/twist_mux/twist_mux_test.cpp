// Sources with the priorities 100 (time-out 0.2 s, hold 1 s), 90 (the same, stamped), 50 (time-out 0.25 s) and 10 (time-out 0.5 s).
#include "components/twist_mux/twist_mux.hpp"

#include <limits>

#include <gmock/gmock.h>

namespace bw {
namespace {

constexpr std::size_t kTeleop = 0, kStamped = 1, kBehavior = 2, kNav = 3;
const Twist2 kAhead{0.5, 0.1}, kBack{-0.2, 0.0}, kTurn{0.0, 1.0};

Time at(double seconds) { return Time::seconds(1000.0 + seconds); }
TwistMux mux() { return TwistMux(TwistMuxOptions{}); }

TEST(TwistMux, PassesTheCommandsOfTheOneThatSpeaksAsTheyAre) {
  TwistMux m = mux();
  EXPECT_EQ(m.command(at(0.0), kNav, kAhead), kAhead);
  EXPECT_EQ(m.command(at(0.1), kNav, Twist2{}), Twist2{});
  EXPECT_EQ(m.active(at(0.2)), kNav);
  EXPECT_EQ(m.active(at(0.7)), std::nullopt);
}

TEST(TwistMux, AHigherOneTakesOverAtOnceAndALowerOneIsNotHeardUntilItsHoldIsOver) {
  TwistMux m = mux();
  m.command(at(0.0), kNav, kAhead);
  EXPECT_EQ(m.command(at(0.05), kTeleop, kBack), kBack);
  for (int i = 2; i <= 21; ++i) EXPECT_EQ(m.command(at(0.05 * i), kNav, kAhead), std::nullopt) << i;
  EXPECT_EQ(m.command(at(1.06), kNav, kAhead), kAhead);
  EXPECT_EQ(m.count(kNav).outranked, 20U);
  EXPECT_EQ(m.count(kNav).passed, 2U);
}

// A behavior ends with zero, and then says nothing: the planner's next command counts once its time-out is over, and no zero is added.
TEST(TwistMux, ABehaviorGoesBeforeThePlannerAndLeavesItTheRobotAQuarterOfASecondAfterItsEnd) {
  TwistMux m = mux();
  m.command(at(0.0), kNav, kAhead);
  EXPECT_EQ(m.command(at(0.05), kBehavior, kTurn), kTurn);
  EXPECT_EQ(m.command(at(0.1), kNav, kAhead), std::nullopt);
  EXPECT_EQ(m.command(at(0.15), kBehavior, Twist2{}), Twist2{});
  EXPECT_EQ(m.command(at(0.4), kNav, kAhead), std::nullopt);
  EXPECT_EQ(m.check(at(0.41)), std::nullopt);
  EXPECT_EQ(m.command(at(0.41), kNav, kAhead), kAhead);
  // A hand goes before both.
  EXPECT_EQ(m.command(at(0.5), kTeleop, kBack), kBack);
  EXPECT_EQ(m.command(at(0.55), kBehavior, kTurn), std::nullopt);
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
  m.command(at(2.0), kNav, kAhead);
  EXPECT_EQ(m.check(at(2.5)), std::nullopt);
  EXPECT_EQ(m.check(at(2.501)), Twist2{});
}

// A simulation begins again: what was heard at 60 s is neither fresh at 1 s nor outranks anybody for the next 59 s.
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
  EXPECT_EQ(m.command(at(0.1), kNav, kTurn), kTurn);
  // Of the one who drives it is a stop, once.
  EXPECT_EQ(m.command(at(0.2), kNav, {kNan, 0.0}), Twist2{});
  EXPECT_EQ(m.command(at(0.3), kNav, {kNan, 0.0}), std::nullopt);
  EXPECT_EQ(m.command(at(0.4), kNav, kAhead), kAhead);
}

TEST(TwistMux, AStampThatIsOlderThanTheTimeOutIsNoCommand) {
  TwistMux m = mux();
  EXPECT_EQ(m.command(at(0.0), kStamped, kAhead, at(-0.201)), std::nullopt);
  EXPECT_EQ(m.command(at(0.0), kStamped, kAhead, at(-10.0)), std::nullopt);
  EXPECT_EQ(m.count(kStamped).late, 2U);
  EXPECT_EQ(m.active(at(0.0)), std::nullopt);
  EXPECT_EQ(m.command(at(0.0), kStamped, kAhead, at(-0.2)), kAhead);
}

TEST(TwistMux, AStampOfAnotherClockOrNoneSaysNothing) {
  TwistMux m = mux();
  EXPECT_EQ(m.command(at(0.0), kStamped, kAhead, at(-10.1)), kAhead);
  EXPECT_EQ(m.command(at(0.1), kStamped, kAhead, at(3.0)), kAhead);
  EXPECT_EQ(m.command(at(0.2), kStamped, kAhead, Time{}), kAhead);
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
