#include "components/local_planner/backward_speed.hpp"

#include <gtest/gtest.h>

namespace bw {
namespace {

// Told to go back at 0.2 m/s, it goes at 0.1: a monitor that lets it creep.
TEST(BackwardSpeed, IsWhatTheRobotWasHeldAt) {
  BackwardSpeed speed;
  EXPECT_EQ(speed.update(0.0, 0.0, 0.2), 0.2);
  EXPECT_EQ(speed.update(-0.2, -0.06, 0.2), 0.2) << "it may still get faster";
  EXPECT_EQ(speed.update(-0.2, -0.1, 0.2), 0.2);
  EXPECT_EQ(speed.update(-0.2, -0.1, 0.2), 0.2);
  EXPECT_EQ(speed.update(-0.2, -0.1, 0.2), 0.2);
  EXPECT_EQ(speed.update(-0.2, -0.1, 0.2), 0.1) << "third cycle without change";
  EXPECT_EQ(speed.update(0.5, 0.4, 0.2), 0.1) << "it is remembered while it drives on";
  EXPECT_EQ(speed.update(-0.1, -0.1, 0.05), 0.05) << "never more than the limit";
  EXPECT_EQ(speed.update(-0.2, -0.18, 0.2), 0.2) << "it went faster";
}

// Something stands close behind: the monitor lets it go no further, which says nothing about other places.
TEST(BackwardSpeed, OfOneThatIsBlockedNothingIsLearnt) {
  BackwardSpeed speed;
  for (int i = 0; i < 20; ++i) EXPECT_EQ(speed.update(-0.2, 0.0, 0.2), 0.2);
}

TEST(BackwardSpeed, IsForgottenAfterAHundredCycles) {
  BackwardSpeed speed;
  for (int i = 0; i < 5; ++i) speed.update(-0.2, -0.1, 0.2);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(speed.update(0.5, 0.5, 0.2), 0.1) << i;
  EXPECT_EQ(speed.update(0.5, 0.5, 0.2), 0.2);
}

}  // namespace
}  // namespace bw
