// The stopping rule of a robot that is a rectangle of 0.51 x 0.43 m, beside walls and in front of things.
#include <cmath>

#include <gtest/gtest.h>

#include "components/model/footprint_outline.hpp"
#include "components/model/random.hpp"
#include "components/safety/collision_monitor.hpp"
#include "tests/components/safety/sweeps.hpp"

namespace bw::safety {
namespace {

constexpr const char* kText = "[[0.255, 0.215], [-0.255, 0.215], [-0.255, -0.215], [0.255, -0.215]]";

/// 1440 beams all round of what walls along x at these positions show.
Sweep corridor(const std::vector<double>& walls, float background = 8.0F) {
  constexpr int kBeams = 1440;
  Sweep sweep{{.angle_min = -std::numbers::pi,
               .angle_increment = 2.0 * std::numbers::pi / kBeams,
               .range_min = 0.05,
               .range_max = 20.0,
               .angle_max = std::numbers::pi},
              std::vector<float>(kBeams, background)};
  for (int i = 0; i < kBeams; ++i) {
    const Vector2 beam = direction(sweep.angle_min + i * sweep.angle_increment);
    float& range = sweep.ranges[static_cast<std::size_t>(i)];
    for (const double y : walls)
      if (y * beam.y() > 1e-3) range = std::min(range, static_cast<float>(y / beam.y()));
  }
  return sweep;
}

Robot robot_of(const std::string& footprint, double radius) {
  Robot robot;  // 1 m/s, stop_deceleration 2 m/s^2
  robot.radius = radius;
  robot.footprint = footprint;
  return robot;
}
Robot rectangle() { return robot_of(kText, 0.3); }
Robot disc_around() { return robot_of("", std::hypot(0.255, 0.215)); }

/// The verdict on a robot that has seen `sweep` for half a second.
Verdict judged(CollisionMonitor& monitor, const Sweep& sweep, const Twist2& wanted,
               const Twist2& actual = {}) {
  Random random(9);
  Verdict verdict;
  Time now = Time::seconds(10.0);
  for (int i = 0; i < 25; ++i) {
    now = now + Duration::milliseconds(20);
    monitor.odometry(now, {}, actual);
    if (i % 5 == 4) {
      Sweep seen = sweep;
      seen.time = now;
      for (float& range : seen.ranges) range += static_cast<float>(1e-4 * random.uniform());
      monitor.sweep(now, seen.view());
    }
    verdict = monitor.judge(now, wanted);
  }
  return verdict;
}
Verdict judged(const Robot& robot, const Sweep& sweep, const Twist2& wanted, const Twist2& actual = {}) {
  CollisionMonitor monitor(robot, {});
  return judged(monitor, sweep, wanted, actual);
}

TEST(FootprintMonitor, DrivesBesideAWallWhereItsDiscWouldStop) {
  const Sweep wall = corridor({0.25});
  EXPECT_EQ(judged(rectangle(), wall, {1.0, 0.0}).action, Action::do_nothing);
  EXPECT_EQ(judged(rectangle(), wall, {1.0, 0.0}).allowed, (Twist2{1.0, 0.0}));
  EXPECT_EQ(judged(disc_around(), wall, {1.0, 0.0}).action, Action::stop);
  EXPECT_EQ(judged(rectangle(), corridor({0.25, -0.25}), {1.0, 0.0}).action, Action::do_nothing);
  // 5 mm too wide for the passage: its side would graze, so at graze_speed.
  EXPECT_NEAR(judged(rectangle(), corridor({0.21}), {1.0, 0.0}).allowed.v, 0.05, 1e-9);
  EXPECT_EQ(judged(rectangle(), corridor({0.18}), {1.0, 0.0}).action, Action::stop);
}

// Front 0.255 m: free distance 0.36 m, less 0.10 m: v 0.1 + v^2 / 4 = 0.26 gives v = -0.2 + sqrt(0.04 + 1.04)
// = 0.8392
TEST(FootprintMonitor, TheStopEndsTenCentimetresBeforeWhatIsThere) {
  const Sweep pillar = sweep_of({{{0.615 + 0.5, 0.0}, 0.5}});
  EXPECT_NEAR(judged(rectangle(), pillar, {1.0, 0.0}).allowed.v, 0.8392, 2e-3);
}

// The corner meets the wall after 0.147 rad; 0.10 m of its travel is 0.30 rad: it may not begin, and turns
// away from one wall freely.
TEST(FootprintMonitor, DoesNotTurnItsCornerIntoTheWall) {
  const Sweep passage = corridor({0.25, -0.25});
  EXPECT_EQ(judged(rectangle(), passage, {0.0, 0.5}).allowed.omega, 0.0);
  EXPECT_EQ(judged(rectangle(), passage, {0.0, 0.5}).cause, kStoppingDistance);
  EXPECT_EQ(judged(disc_around(), passage, {0.0, 0.5}).allowed.omega, 0.5) << "a disc turns freely";
  EXPECT_EQ(judged(rectangle(), corridor({0.34}), {0.0, 0.5}).allowed.omega, 0.5)
      << "no corner reaches 0.34 m";
}

// At 0.32 m the corner meets the wall after asin(0.32 / 0.33354) - 0.70054 = 0.5846 rad, at a lever of
// 0.33354 m. The wheels,
// 0.195 m off the middle, brake with 2 m/s^2: 10.26 rad/s^2. 0.1 w + w^2 / 20.51 = 0.5846 - 0.1 / 0.33354
// gives w = 1.62.
TEST(FootprintMonitor, TurnsAsFastAsItCanStop) {
  const Verdict verdict = judged(rectangle(), corridor({0.32}), {0.0, 3.0});
  EXPECT_NEAR(verdict.allowed.omega, 1.62, 0.03);  // points of the wall are up to 2 mm apart there
  EXPECT_EQ(verdict.action, Action::approach);
}

// The laser sees 135 degrees to either side. A tail reaches 0.6 m back: what it swings through nobody sees,
// so that its corner, at hypot(0.6, 0.1) m, moves at 0.1 m/s: 0.164 rad/s. Seen all round it rotates as it is
// told, and a disc always does.
TEST(FootprintMonitor, ATailSwingsSlowlyThroughWhatIsNotSeen) {
  const Robot tail = robot_of("[[0.1, 0.1], [-0.6, 0.1], [-0.6, -0.1], [0.1, -0.1]]", 0.0);
  for (const Twist2 wanted : {Twist2{0.0, 1.0}, Twist2{0.0, -1.0}, Twist2{1e-6, 1.0}}) {
    const Verdict verdict = judged(tail, sweep_of({}), wanted);
    EXPECT_NEAR(std::abs(verdict.allowed.omega), 0.1 / std::hypot(0.6, 0.1), 1e-3);
    EXPECT_EQ(verdict.cause, kSight);
  }
  EXPECT_EQ(judged(tail, corridor({}), {0.0, 1.0}).allowed.omega, 1.0);
  EXPECT_EQ(judged(disc_around(), sweep_of({}), {0.0, 1.0}).allowed.omega, 1.0);
}

TEST(FootprintMonitor, WhatIsToldMakesTheOutlineLargerAndNeverSmaller) {
  const Sweep wall = corridor({0.25});
  CollisionMonitor monitor(rectangle(), {});
  EXPECT_EQ(judged(monitor, wall, {1.0, 0.0}).action, Action::do_nothing);
  monitor.set_footprint({std::hypot(0.255, 0.215), {}});
  EXPECT_EQ(judged(monitor, wall, {1.0, 0.0}).action, Action::stop);
  // One message with a disc of 1 mm: what the robot file says stays.
  monitor.set_footprint({0.001, {}});
  EXPECT_EQ(CollisionMonitor(rectangle(), {}).kept_free().polygon, monitor.kept_free().polygon);
  CollisionMonitor disc(disc_around(), {});
  disc.set_footprint(
      footprint_of("[[0.001, 0.001], [-0.001, 0.001], [-0.001, -0.001], [0.001, -0.001]]", 0.0).footprint);
  EXPECT_FALSE(disc.kept_free().is_polygon());
  EXPECT_EQ(judged(disc, wall, {1.0, 0.0}).action, Action::stop);
  CollisionMonitorOptions options;
  options.stopping.padding = 0.05;
  monitor.set_options(options);
  EXPECT_NEAR(inscribed_radius(monitor.kept_free()), 0.265, 1e-12);
}

TEST(FootprintMonitor, NarrowThingsAreMetByTheFront) {
  // Legs 1 m ahead: front at 0.255 + 0.2 m; 0.545 m to be down to 0.2 m/s: 0.1 v + (v^2 - 0.04) / 4 = 0.545.
  const Verdict verdict = judged(rectangle(), sweep_of({{{1.05, 0.0}, 0.05}}), {1.5, 0.0});
  EXPECT_NEAR(verdict.allowed.v, -0.2 + std::sqrt(0.04 + 0.04 + 4.0 * 0.545), 3e-3);
  EXPECT_EQ(verdict.cause, kNarrowThing);
}

}  // namespace
}  // namespace bw::safety
