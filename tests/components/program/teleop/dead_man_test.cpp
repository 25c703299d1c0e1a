#include "components/program/teleop/dead_man.hpp"

#include <gtest/gtest.h>

namespace bw {
namespace {

constexpr Time kStart{1'000'000'000};
Time after(std::int64_t ms) { return kStart + Duration::milliseconds(ms); }

TEST(DeadMan, StandsUntilAKeyAnd200MsAfterTheLast) {
  DeadMan hand({.v = 0.4, .omega = 1.0});
  EXPECT_EQ(hand.twist(kStart), Twist2{});
  hand.press(kStart, {.forward = 1});
  EXPECT_EQ(hand.twist(after(199)), (Twist2{0.2, 0.0})) << "half of 0.4: it begins with 50 %";
  EXPECT_EQ(hand.twist(after(200)), Twist2{});
  // Held, the keyboard repeats it from 500 ms on every 33 ms: without a gap from there, and 200 ms beyond the
  // last.
  for (int ms = 500; ms <= 797; ms += 33) {
    hand.press(after(ms), {.forward = 1});
    EXPECT_TRUE(hand.is_driving(after(ms + 32)));
  }
  EXPECT_TRUE(hand.is_driving(after(996)));
  EXPECT_FALSE(hand.is_driving(after(997)));
}

TEST(DeadMan, AnotherKeyTakesOverAndLettingGoIsAtOnce) {
  DeadMan hand({.v = 0.4, .omega = 1.0});
  hand.press(kStart, {.forward = -1});
  EXPECT_EQ(hand.twist(kStart), (Twist2{-0.1, 0.0})) << "backwards at half the speed";
  hand.press(after(10), {.rotation = 1});
  EXPECT_EQ(hand.twist(after(10)), (Twist2{0.0, 0.5}));
  hand.let_go();
  EXPECT_EQ(hand.twist(after(10)), Twist2{});
}

TEST(DeadMan, SpeedStaysBetweenATenthAndTheLimits) {
  DeadMan hand({.v = 0.4, .omega = 1.0});
  for (int i = 0; i < 20; ++i) hand.change_speed(+1);
  hand.press(kStart, {.forward = 1, .rotation = -1});
  EXPECT_EQ(hand.twist(kStart), (Twist2{0.4, -1.0}));
  for (int i = 0; i < 20; ++i) hand.change_speed(-1);
  EXPECT_DOUBLE_EQ(hand.share(), 0.1);
}

}  // namespace
}  // namespace bw
