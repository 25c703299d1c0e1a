#include "components/evaluation/rms_jerk.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace bw {
namespace {

double rms_of(double (*speed)(double), double seconds, double dt) {
  RmsJerk jerk;
  for (int i = 0; i * dt <= seconds; ++i) jerk.add(Time::seconds(10.0 + i * dt), speed(i * dt));
  return jerk.value();
}

TEST(RmsJerk, SteadySpeedAndSteadyAccelerationHaveNone) {
  EXPECT_EQ(rms_of([](double) { return 0.7; }, 5.0, 0.02), 0.0);
  EXPECT_NEAR(rms_of([](double t) { return 0.3 * t; }, 5.0, 0.02), 0.0, 1e-9);
}

TEST(RmsJerk, AParabolaHasItsSecondDerivative) {
  // v = t^2: second derivative 2 everywhere, and the difference formula is exact for parabolas (read at
  // multiples of 0.1 s).
  EXPECT_NEAR(rms_of([](double t) { return t * t; }, 5.0, 0.02), 2.0, 1e-6);
}

TEST(RmsJerk, ASinusHasTheAmplitudeOfItsSecondDifference) {
  // v = sin(w t): |second difference| = (2 - 2 cos(w h)) / h^2 times sin; rms over whole periods is that over
  // sqrt 2.
  const double w = 2.0 * std::numbers::pi;  // one period per second
  const double expected = (2.0 - 2.0 * std::cos(w * 0.1)) / 0.01 / std::numbers::sqrt2;
  EXPECT_NEAR(rms_of([](double t) { return std::sin(2.0 * std::numbers::pi * t); }, 40.1, 0.02), expected,
              0.01 * expected);
}

TEST(RmsJerk, TheSampleRateBarelyMatters) {
  const auto speed = [](double t) { return 0.5 + 0.4 * std::sin(1.3 * t); };
  EXPECT_NEAR(rms_of(speed, 60.0, 0.01) / rms_of(speed, 60.0, 0.05), 1.0, 0.02);
}

TEST(RmsJerk, RepeatedStampsAreIgnored) {
  RmsJerk jerk;
  for (int i = 0; i < 100; ++i) {
    jerk.add(Time::seconds(1.0 + 0.1 * i), 0.5);
    jerk.add(Time::seconds(1.0 + 0.1 * i), 9.0);
  }
  EXPECT_EQ(jerk.value(), 0.0);
}

}  // namespace
}  // namespace bw
