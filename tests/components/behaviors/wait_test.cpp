#include "components/behaviors/wait.hpp"

#include <gtest/gtest.h>

namespace bw {
namespace {

using State = BehaviorStep::State;

BehaviorStep step(Wait& wait, double now) {
  BehaviorSituation situation;
  situation.problem.now = Time::seconds(now);
  situation.missing = "no odometry yet";  // it needs none
  return wait.step(situation);
}

TEST(Wait, TellsWhatIsLeftAndEndsInTime) {
  Wait wait(Duration::seconds(2.0), Time::seconds(100.0));
  const BehaviorStep first = step(wait, 100.5);
  EXPECT_EQ(first.state, State::running);
  EXPECT_EQ(first.left, Duration::seconds(1.5));
  EXPECT_EQ(first.command, std::nullopt) << "who waits drives nobody";
  EXPECT_EQ(step(wait, 101.999).state, State::running);
  EXPECT_EQ(step(wait, 102.0).state, State::succeeded);
}

TEST(Wait, NoneOrLessIsOverAtOnce) {
  for (const double seconds : {0.0, -3.0}) {
    Wait wait(Duration::seconds(seconds), Time::seconds(100.0));
    EXPECT_EQ(step(wait, 100.0).state, State::succeeded);
  }
}

TEST(Wait, AClockThatGoesBackDoesNotProlongIt) {
  Wait wait(Duration::seconds(2.0), Time::seconds(100.0));
  step(wait, 101.5);
  EXPECT_EQ(step(wait, 3.0).left, Duration::seconds(0.5));
  EXPECT_EQ(step(wait, 3.5).state, State::succeeded);
}

}  // namespace
}  // namespace bw
