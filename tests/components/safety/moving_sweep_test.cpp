// Sweeps that take their time, on a robot that rotates.
#include "tests/components/model/moving_sweep.hpp"

#include <gtest/gtest.h>

#include "components/model/sweep_motion.hpp"
#include "components/safety/collision_monitor.hpp"

namespace bw::safety {
namespace {

TEST(MovingSweep, PointsAreWhereTheyWereAtItsTime) {
  test::MovingSweep moving{.twist = {0.3, 1.9}};
  LaserSweep sweep = moving.scan();
  const std::vector<Pose2> poses =
      beam_poses(sweep, moving.X_BL, [&](Time time) { return moving.X_OB(time); });
  sweep.beam_poses = poses;
  const CheckedSweep checked = check_sweep(sweep, {});
  ASSERT_EQ(checked.fault, SweepFault::none);
  ASSERT_GT(checked.points.size(), 200U);
  for (const SeenPoint& point : checked.points) ASSERT_NEAR(point.position.x(), 2.5, 1e-6);
}

/// What is allowed of 1 m/s straight on, at the end of the sweep.
double allowed(test::MovingSweep moving, bool at_once) {
  LaserSweep sweep = moving.scan();
  if (at_once) sweep.time_increment = 0.0;
  CollisionMonitor monitor(Robot{}, {});  // radius 0.3 m
  const Time now = moving.time + Duration::seconds(1.0 / 14.0);
  monitor.odometry(now, moving.X_OB(now), moving.twist);
  monitor.sweep(now, sweep);
  return monitor.judge(now, {1.0, 0.0}).allowed.v;
}

// At 0.6 m/s towards a wall, by a laser that looks backward: what is ahead it sees at both ends of its
// revolution, 1/14 s from the middle, in which the robot goes 4.3 cm. The monitor must allow what it does
// when all beams are of the sweep's time; taken for one, the first ones put the wall 4.3 cm nearer: with 0.1
// s and 2 m/s^2 some 0.1 m/s less.
TEST(MovingSweep, TheMonitorFindsWhereEachBeamWasTaken) {
  const test::MovingSweep slow{.twist = {0.6, 0.3}, .X_BL = {0.0, 0.0, std::numbers::pi}, .wall = 0.7};
  test::MovingSweep instant = slow;
  instant.period = 1e-9;
  const double right = allowed(instant, false);
  EXPECT_GT(right, 0.1);
  EXPECT_NEAR(allowed(slow, false), right, 2e-3);
  EXPECT_NEAR(allowed(slow, true), right - 0.1, 0.04);
}

}  // namespace
}  // namespace bw::safety
