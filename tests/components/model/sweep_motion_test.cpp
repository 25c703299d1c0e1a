#include "components/model/sweep_motion.hpp"

#include <gtest/gtest.h>

#include "tests/components/model/moving_sweep.hpp"

namespace bw {
namespace {

void expect_near(const Pose2& a, const Pose2& b, double tolerance, double at) {
  EXPECT_NEAR(a.x, b.x, tolerance) << at;
  EXPECT_NEAR(a.y, b.y, tolerance) << at;
  EXPECT_NEAR(wrap_angle(a.theta - b.theta), 0.0, tolerance) << at;
}

// What holds one velocity of the body is on its arc at any share of the time, before and behind too; so is
// what sits aside on it, which has a velocity to the side.
TEST(SweepMotion, TheWayOfOneVelocityIsItsArc) {
  const Pose2 start{1.0, -2.0, 3.0};
  const Pose2 aside{0.2, 0.3, -1.0};
  for (const Twist2& twist :
       {Twist2{0.6, 1.9}, Twist2{-0.3, -2.5}, Twist2{0.6, 0.0}, Twist2{0.0, 1.0}, Twist2{0.5, 1e-9}}) {
    for (const double share : {-0.5, 0.0, 0.3, 1.0, 1.4}) {
      const Pose2 there = advance_exact(start, twist, 0.2);
      const Pose2 between = advance_exact(start, twist, 0.2 * share);
      expect_near(pose_between(start, there, share), between, 1e-12, share);
      expect_near(pose_between(start * aside, there * aside, share), between * aside, 1e-12, share);
    }
  }
}

TEST(SweepMotion, EachBeamIsFromWhereTheScannerWas) {
  for (const bool clockwise : {true, false}) {
    test::MovingSweep moving{.clockwise = clockwise};
    const LaserSweep sweep = moving.scan();
    const auto pose_at = [&](Time time) { return moving.X_OB(time); };
    const std::vector<Pose2> poses = beam_poses(sweep, moving.X_BL, pose_at);
    ASSERT_EQ(poses.size(), 720U);
    // Times are whole nanoseconds: 2 nm at these speeds.
    expect_near(poses[360], moving.X_BL, 1e-8, 360);
    const double end =
        clockwise ? 1.0 / 14.0 : -1.0 / 14.0;  // the first beam of a clockwise revolution is taken last
    expect_near(poses[0], advance_exact({}, moving.twist, end) * moving.X_BL, 1e-8, 0);
    expect_near(poses[180], advance_exact({}, moving.twist, end / 2.0) * moving.X_BL, 1e-8, 180);
    for (std::size_t i = 0; i < 720; ++i) {
      const double range = sweep.ranges[i];
      if (!(range < 8.0)) continue;
      const double angle = sweep.angle_min + static_cast<double>(i) * sweep.angle_increment;
      ASSERT_NEAR((poses[i] * Vector2(range * direction(angle))).x(), 2.5, 1e-6) << i;
    }
  }
}

// Odometry comes later than beams: what is not known yet goes on as before. Of a changing velocity the knots
// around a beam count.
TEST(SweepMotion, WhatIsNotKnownYetGoesOnAsBefore) {
  test::MovingSweep moving;
  const LaserSweep sweep = moving.scan();
  const auto known_until = [&](double seconds) {
    return beam_poses(sweep, moving.X_BL, [&, seconds](Time time) -> std::optional<Pose2> {
      if ((time - moving.time).to_seconds() > seconds) return std::nullopt;
      return moving.X_OB(time);
    });
  };
  const Pose2 last = advance_exact({}, moving.twist, 1.0 / 14.0) * moving.X_BL;
  expect_near(known_until(1.0).at(0), last, 1e-8, 0);
  expect_near(known_until(0.03).at(0), last, 1e-7, 0);
  EXPECT_TRUE(known_until(-0.06).empty());  // one knot
  // At rest until the middle, then driving on at 0.7 m/s: half a turn later, 1/14 s, 5 cm ahead. Of seven
  // intervals the fourth holds the middle, where the path begins 1/98 s later than its straight line: at most
  // 0.7 / 98 / 4 = 2 mm off.
  const auto pose_at = [&](Time time) {
    return Pose2{0.7 * std::max(0.0, (time - moving.time).to_seconds()), 0.0, 0.0};
  };
  const std::vector<Pose2> poses = beam_poses(sweep, {}, pose_at);
  EXPECT_NEAR(poses[0].x, 0.05, 1e-6);
  EXPECT_NEAR(poses[719].x, 0.0, 1e-12);
  EXPECT_NEAR(poses[360].x, 0.0, 0.0036);
}

TEST(SweepMotion, BeamsOfOneTimeNeedNoPoses) {
  test::MovingSweep moving;
  LaserSweep sweep = moving.scan();
  sweep.time_increment = 0.0;
  int asked = 0;
  EXPECT_TRUE(beam_poses(sweep, {}, [&](Time) { return ++asked, Pose2{}; }).empty());
  EXPECT_EQ(asked, 0);
  EXPECT_EQ(&scanner_at(sweep, 17), &sweep.X_FL);
}

TEST(SweepMotion, PosesThatCannotBeAreAFaultOfTheSweep) {
  test::MovingSweep moving;
  LaserSweep sweep = moving.scan();
  std::vector<Pose2> poses(720);
  sweep.beam_poses = poses;
  EXPECT_EQ(fault_of(sweep), SweepFault::none);
  poses[719].theta = std::nan("");
  EXPECT_EQ(fault_of(sweep), SweepFault::bad_pose);
  poses[719] = {2e6, 0.0, 0.0};
  EXPECT_EQ(fault_of(sweep), SweepFault::bad_pose);
  sweep.beam_poses = std::span(poses).first(719);
  EXPECT_EQ(fault_of(sweep), SweepFault::bad_pose);
}

}  // namespace
}  // namespace bw
