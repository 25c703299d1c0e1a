#include "components/safety/limit_hold.hpp"

#include <gtest/gtest.h>

namespace bw::safety {
namespace {

TEST(LimitHold, FallsAtOnceAndRisesLateAtTheAcceleration) {
  LimitHold hold(Duration::milliseconds(400), 1.0);
  double t = 0.0;
  const auto after = [&](double seconds, double limit) {
    double held = 0.0;
    for (const double end = t + seconds; t < end - 1e-9; t += 0.02)
      held = hold.update(Time::seconds(t), limit, 1);
    return held;
  };
  EXPECT_EQ(after(1.0, 1.0), 1.0);
  EXPECT_EQ(after(0.02, 0.3), 0.3);
  EXPECT_EQ(after(0.38, 1.0), 0.3);
  EXPECT_NEAR(after(0.3, 1.0), 0.3 + 0.3, 0.021);  // from 0.4 s after the tight one
  EXPECT_EQ(after(0.02, 0.1), 0.1);
  EXPECT_EQ(after(2.0, 0.5), 0.5);
}

TEST(LimitHold, ASweepThatFlickersDoesNotStopAndGo) {
  LimitHold hold(Duration::milliseconds(400), 1.0);
  for (int i = 0; i < 500; ++i) {  // every fifth cycle says stop
    EXPECT_EQ(hold.update(Time::seconds(0.02 * i), i % 5 == 0 ? 0.0 : 1.0, 1), 0.0);
  }
}

TEST(LimitHold, TheOtherDirectionStartsAfresh) {
  LimitHold hold(Duration::milliseconds(400), 1.0);
  EXPECT_EQ(hold.update(Time::seconds(0.0), 0.0, 1), 0.0);
  EXPECT_EQ(hold.update(Time::seconds(0.02), 0.2, -1), 0.2);
}

}  // namespace
}  // namespace bw::safety
