// Somebody steps out from behind a wall 0.2 m beside the robot's path, at 1 m/s across it, and the robot
// comes at 1 m/s (row 33 of tests/README.md). Nobody plans, tracks or predicts; only the collision monitor
// sees it.
//
// "d ahead": when the rim of the person's disc (0.3 m) enters the path of the robot's disc, d [m] lie between
// the two along the path. What braking at a = 2 m/s^2 can do, with t_r from the person being in the way to
// braking wheels:
//
//   speed at contact  v_c = sqrt(v^2 - 2 a (d - v t_r)),  none if d > v t_r + v^2 / 2a
//
// t_r is at most 0.17 s: the legs, which alone are seen, come into the path (less narrow_margin) up to 30 ms
// after the rim of the body; then a period of the laser (100 ms), a cycle of motor control (20 ms), the
// physics (10 ms) and the ramp of the wheels (10 ms). At d = 0.5 m the robot can stand (0.42 m); from d =
// 0.40 m down it cannot be below 0.3 m/s: that is physics.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/faults/meeting.hpp"

namespace bw {
namespace {

constexpr double kWall = 0.5;  // y of the wall [m]
constexpr double kEnter = kRobot + kPerson;
constexpr double kReaction = 0.17;  // [s], see above

/// Speed at contact [m/s] when nothing but the brakes can help.
double physics(double ahead) {
  const double square = 1.0 - 4.0 * (ahead - kReaction);
  return square > 0.0 ? std::min(1.0, std::sqrt(square)) : 0.0;
}

std::string scene(double wall_end, const std::string& person) {
  return fmt::format(
      "      walls: [{{x1: -5.0, y1: {0}, x2: {1}, y2: {0}}}, {{x1: -5.0, y1: -2.0, x2: 30.0, y2: -2.0}}]\n"
      "      people_react: false\n      people: {{scripted: [{2}]}}\n",
      kWall, wall_end, person);
}

/// When the robot, undisturbed, is at x [m]: measured once.
double time_at(double x) {
  static const std::vector<std::pair<double, double>> path = [] {
    std::vector<std::pair<double, double>> list;
    GuardedDrive drive;
    drive.world = scene(-4.0, "");
    drive.wish = [](double) { return Twist2{1.0, 0.0}; };
    drive.see = [&](double t, const auto& truth) { list.emplace_back(truth.pose().position().x(), t); };
    drive.run(9.0);
    return list;
  }();
  const auto after = std::lower_bound(path.begin(), path.end(), std::pair(x, 0.0));
  return after->second;
}

/// Trial i of n varies the time against the laser's, the steps of the person and the noise.
Meeting step_out(double ahead, int i, int n) {
  const double x = 5.0 + 0.1 * i / n;
  const double start_y = 2.0 + 1.4 * std::fmod(0.618 * i, 1.0);
  const double enters = time_at(x - kEnter - ahead);
  GuardedDrive drive;
  drive.seed = static_cast<std::uint64_t>(i) + 1;
  drive.world =
      scene(x - kPerson - 0.05,
            fmt::format("{{waypoints: [{{x: {0}, y: {1}}}, {{x: {0}, y: -1.6}}], speed: 1.0, start_time: "
                        "{2}}}",
                        x, start_y, enters - (start_y - kEnter)));
  return watch(drive, enters + 2.0);
}

Outcome trials(double ahead) {
  const int n = fault_trials();
  const Outcome outcome = outcome_of(n, [&](int i) { return step_out(ahead, i, n); });
  std::printf(
      "%.2f m ahead, %d trials: %d contacts, the fastest at %.2f m/s, least gap %.3f m; braking alone: %.2f "
      "m/s\n",
      ahead, n, outcome.contacts, outcome.worst, outcome.least_gap, physics(ahead));
  return outcome;
}

TEST(StepOut, OneMetreAheadNobodyIsTouched) {
  const Outcome outcome = trials(1.0);
  EXPECT_EQ(outcome.contacts, 0);
}

TEST(StepOut, HalfAMetreAheadNobodyIsTouchedFasterThan30CentimetresPerSecond) {
  EXPECT_LE(trials(0.5).worst, 0.3);
}

TEST(StepOut, NearerItIsWhatBrakingAllows) {
  for (const double ahead : {0.35, 0.2}) EXPECT_LE(trials(ahead).worst, physics(ahead) + 0.02);
}

}  // namespace
}  // namespace bw
