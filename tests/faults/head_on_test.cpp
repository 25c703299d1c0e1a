// Somebody walks straight at the robot at 1.3 m/s and does not react; the robot comes at 1 m/s. Nobody plans,
// tracks or predicts; only the collision monitor sees it.
//
// To stand when the discs touch, it must begin v t_r + v^2 / 2a + u (t_r + v / a) before that, u = 1.3 m/s.
// t_r is 0.07 s from a sweep on: a cycle of motor control, the physics, the ramp of the wheels; how old the
// sweep is the rule counts itself. That is 0.07 + 0.25 + 0.74 = 1.06 m, and 0.23 m more before the legs,
// which are behind the rim of the body: 1.29 m. With approach_speed 1.6 (ISO 13855: a person who walks) the
// rule begins at 0.1 + 0.25 + 0.96 + 0.1 = 1.41 m and ends at 1.6 * 0.1 + 0.1 = 0.26 m: the robot stands.
// With 0 it begins at 0.45 m (0.54 m before something narrow), which two who close at 2.3 m/s have passed in
// 0.23 s.
#include <cmath>
#include <cstdio>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/faults/meeting.hpp"

namespace bw {
namespace {

constexpr double kWalk = 1.3;  // speed of the person [m/s]

/// Trial i of n varies the time against the laser's, the steps of the person, the side and the noise.
Meeting head_on(const std::string& monitor, int i, int n) {
  const double y = 0.2 * (2.0 * std::fmod(0.618 * i, 1.0) - 1.0);
  const double x = 9.0 + 2.0 * std::fmod(0.414 * i, 1.0);
  const double start = 1.0 + 0.1 * i / n;
  GuardedDrive drive;
  drive.seed = static_cast<std::uint64_t>(i) + 1;
  drive.monitor = monitor;
  drive.world = fmt::format(
      "      walls: [{{x1: -5.0, y1: 2.0, x2: 30.0, y2: 2.0}}, {{x1: -5.0, y1: -2.0, x2: 30.0, y2: -2.0}}]\n"
      "      people_react: false\n      people: {{scripted: [{{waypoints: [{{x: {0}, y: {1}}}, {{x: -5.0, y: "
      "{1}}}], speed: {2}, start_time: {3}}}]}}\n",
      x, y, kWalk, start);
  return watch(drive, start + x / kWalk);
}

Outcome trials(int n, double approach_speed) {
  const std::string monitor = fmt::format("      stopping: {{approach_speed: {}}}\n", approach_speed);
  const Outcome outcome = outcome_of(n, [&](int i) { return head_on(monitor, i, n); });
  std::printf("approach_speed %.1f m/s, %d trials: %d contacts, the fastest at %.2f m/s\n", approach_speed, n,
              outcome.contacts, outcome.worst);
  return outcome;
}

TEST(HeadOn, TheRobotStandsWhenThePersonIsThere) {
  const int n = fault_trials();
  const Outcome outcome = trials(n, 1.6);
  EXPECT_LE(outcome.worst, 0.1);
  EXPECT_EQ(outcome.contacts, n);  // the person walks on into it: it was met, not passed
}

// Who expects that what is ahead stands has no time: the scene is one that needs approach_speed.
TEST(HeadOn, WithoutApproachSpeedItIsTooLate) { EXPECT_GT(trials(10, 0.0).worst, 0.5); }

}  // namespace
}  // namespace bw
