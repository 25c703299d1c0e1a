// Boards that do what they are told, and others. Counts every 25 ms, commands every 50 ms, a wheel of 3.32 mm
// a count (144 to a revolution).
#include "components/robot_base/eddie/command_check.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bw::eddie {
namespace {

using testing::HasSubstr;

constexpr double kCount = 0.00332, kRamp = 3.0;

struct Course {
  std::string said;  ///< the first contradiction
  double at = -1.0;  ///< [s]
};

/// Wheels follow `of_command` of the commanded speed at kRamp, 50 ms late; `more` is added to what they do.
Course drive(
    const std::function<WheelSpeeds(double)>& commanded, const WheelSpeeds& of_command, double seconds,
    const std::function<double(double)>& more = [](double) { return 0.0; }, double count = kCount) {
  CommandCheck check(count, kRamp);
  WheelSpeeds speed, travel;
  for (int i = 0; i * 0.005 < seconds; ++i) {
    const double t = i * 0.005;
    const Time now = Time::seconds(10.0 + t);
    if (i % 10 == 0) check.told(now, commanded(t));
    const WheelSpeeds meant = commanded(std::max(0.0, t - 0.05));
    for (const auto wheel : {&WheelSpeeds::left, &WheelSpeeds::right}) {
      const double change = meant.*wheel * of_command.*wheel - speed.*wheel;
      speed.*wheel += std::clamp(change, -kRamp * 0.005, kRamp * 0.005);
      travel.*wheel += (speed.*wheel + more(t)) * 0.005;
    }
    if (i % 5 != 0) continue;
    const auto counted = [&](double metres) { return std::floor(metres / count) * count; };
    const std::string said = check.measured(now, {counted(travel.left), counted(travel.right)});
    if (!said.empty()) return {said, t};
  }
  return {};
}

WheelSpeeds ahead(double t) { return t < 0.5 ? WheelSpeeds{} : WheelSpeeds{0.4, 0.4}; }

TEST(EddieCommandCheck, ABoardThatObeysContradictsNothing) {
  const auto lively = [](double t) {
    return WheelSpeeds{0.5 * std::sin(1.7 * t), std::fmod(t, 3.0) < 1.5 ? 0.5 : -0.3};
  };
  EXPECT_EQ(drive(lively, {1.0, 1.0}, 60.0).said, "");
  EXPECT_EQ(drive(lively, {1.1, 0.85}, 60.0).said, "");
  EXPECT_EQ(drive(
                lively, {1.0, 1.0}, 60.0, [](double) { return 0.0; }, 0.0133)
                .said,
            "");
  EXPECT_EQ(drive(ahead, {0.0, 0.0}, 20.0).said, "");  // stalled: not this one's affair
}

// Twice of 0.4 m/s is beyond 1.5 * 0.4 + 0.083 = 0.68 m/s, which the mean over 0.2 s passes within 0.05 + 0.8
// / 3 + 0.1 s; three readings.
TEST(EddieCommandCheck, TwiceTheSpeedIsTheOtherUnit) {
  const Course course = drive(ahead, {2.0, 2.0}, 5.0);
  EXPECT_THAT(course.said, HasSubstr("per half second"));
  EXPECT_GT(course.at, 0.5);
  EXPECT_LT(course.at, 0.5 + 0.05 + 0.27 + 0.1 + 0.075);
}

TEST(EddieCommandCheck, HalfTheSpeedIsTheOtherUnitToo) {
  const Course course = drive(ahead, {0.5, 0.5}, 5.0);
  EXPECT_THAT(course.said, HasSubstr("does GOSPD count positions per second"));
  EXPECT_LT(course.at, 0.5 + 1.0 + 0.3 + 0.4 + 0.25 + 0.2);
}

// 0.083 m/s backwards is reached, 50 ms late, after 28 ms more; the mean over 0.2 s follows.
TEST(EddieCommandCheck, TheOtherWayRoundIsFound) {
  const Course course = drive(ahead, {1.0, -1.0}, 5.0);
  EXPECT_THAT(course.said, HasSubstr("right wheel"));
  EXPECT_THAT(course.said, HasSubstr("the wrong way round"));
  EXPECT_LT(course.at, 0.5 + 0.05 + 0.2 + 0.075);
}

TEST(EddieCommandCheck, AWheelThatTurnsWithoutACommandIsFoundWithin300Ms) {
  const Course course = drive([](double) { return WheelSpeeds{}; }, {1.0, 1.0}, 5.0,
                              [](double t) { return t < 2.0 ? 0.0 : 0.2; });
  EXPECT_THAT(course.said, HasSubstr("told to stand"));
  EXPECT_GT(course.at, 2.0);
  EXPECT_LT(course.at, 2.3);
}

// Speed v falls at 3 m/s^2, and shows 0.3 s longer.
TEST(EddieCommandCheck, BrakingFromFullSpeedIsNoContradiction) {
  EXPECT_EQ(drive(
                [](double t) {
                  return t < 2.0 ? WheelSpeeds{0.9, 0.9} : WheelSpeeds{};
                },
                {1.0, 1.0}, 6.0)
                .said,
            "");
}

// The unit at every speed that is driven with: twice and half are found from 0.2 m/s on.
TEST(EddieCommandCheck, TheUnitIsFoundAtEverySpeed) {
  for (double speed = 0.2; speed < 0.95; speed += 0.05) {
    for (const double sign : {1.0, -1.0}) {
      const auto steady = [&](double) { return WheelSpeeds{sign * speed, sign * speed}; };
      EXPECT_THAT(drive(steady, {2.0, 2.0}, 5.0).said, HasSubstr("per half second")) << speed;
      EXPECT_THAT(drive(steady, {0.5, 0.5}, 5.0).said, HasSubstr("per second")) << speed;
    }
  }
}

TEST(EddieCommandCheck, OneDamagedReadingContradictsNothing) {
  CommandCheck check(kCount, kRamp);
  check.told(Time::seconds(1.0), {});
  for (int i = 0; i < 100; ++i) {
    const double travel = i == 50 ? 3.0 : 0.0;
    EXPECT_EQ(check.measured(Time::seconds(1.0 + 0.025 * i), {travel, travel}), "") << i;
  }
}

}  // namespace
}  // namespace bw::eddie
