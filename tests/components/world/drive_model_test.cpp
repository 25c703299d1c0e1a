// The base on the floor: closed forms of its motion, its encoders and its walls.
#include "components/world/drive_model.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace bw {
namespace {

constexpr double kStep = 0.01;
const StaticScene kOpenFloor({}, std::nullopt);

WheelCommand rim(const Robot& robot, double left, double right) {
  return {left / robot.wheel_radius, right / robot.wheel_radius};
}

void run(DriveModel& drive, double seconds, const StaticScene& scene = kOpenFloor) {
  for (int i = 0; i < std::lround(seconds / kStep); ++i) drive.step(kStep, scene);
}

TEST(DriveModel, SpeedsUpAtTheWheelLimit) {
  DriveOptions options;
  options.wheel_acceleration = 2.0;
  const Robot robot;
  DriveModel drive(options, robot, {}, Random(1));
  ASSERT_TRUE(drive.command(rim(robot, 1.0, 1.0)));
  run(drive, 0.25);
  EXPECT_NEAR(drive.twist().v, 0.5, 1e-12);                     // 2 m/s^2 for 0.25 s
  EXPECT_NEAR(drive.pose().x, 0.5 * 2.0 * 0.25 * 0.25, 1e-12);  // a t^2 / 2
  run(drive, 1.0);
  EXPECT_NEAR(drive.twist().v, 1.0, 1e-12);
  EXPECT_NEAR(drive.pose().x, 0.25 + 0.75, 1e-9);  // a t^2 / 2 = 0.25 m to 1 m/s, then 0.75 s of it
}

TEST(DriveModel, WheelsFurtherApartTurnLess) {
  // omega = (0.7 - 0.3) / (b (1 + 0.03)); the wheels' travel, which encoders see, stays what it was.
  DriveOptions options;
  options.separation_error = 0.03;
  const Robot robot;
  DriveModel drive(options, robot, {}, Random(1));
  ASSERT_TRUE(drive.command(rim(robot, 0.3, 0.7)));
  run(drive, 1.0);
  EXPECT_NEAR(drive.twist().omega, 0.4 / (1.03 * robot.wheel_separation), 1e-12);
  EXPECT_NEAR(drive.twist().v, 0.5, 1e-12);
}

TEST(DriveModel, DrivesACircle) {
  // Rim speeds 0.6 and 0.8: v = 0.7, omega = 0.2 / 0.39, radius v / omega = 1.365 m.
  const Robot robot;
  DriveModel drive({}, robot, {1.0, 2.0, 0.4}, Random(1));
  ASSERT_TRUE(drive.command(rim(robot, 0.6, 0.8)));
  run(drive, 1.0);
  const Pose2 from = drive.pose();
  run(drive, 3.0);
  const double omega = 0.2 / robot.wheel_separation;
  const double radius = 0.7 / omega;
  const double heading = from.theta + 3.0 * omega;
  EXPECT_NEAR(drive.pose().x, from.x + radius * (std::sin(heading) - std::sin(from.theta)), 1e-9);
  EXPECT_NEAR(drive.pose().y, from.y - radius * (std::cos(heading) - std::cos(from.theta)), 1e-9);
  EXPECT_NEAR(drive.pose().theta, wrap_angle(heading), 1e-9);
  EXPECT_NEAR(drive.twist().omega, omega, 1e-12);
}

TEST(DriveModel, WheelsOfTwoSizesGoAsFarAsTheyAreLarge) {
  // Equal rates, the right radius twice 1.25 / 2.25 of the mean: to the left; and each counts its own
  // revolutions, the same.
  Robot robot;
  robot.wheel_radius_ratio = 1.25;
  DriveModel drive({}, robot, {}, Random(1));
  ASSERT_TRUE(drive.command(rim(robot, 0.5, 0.5)));
  run(drive, 2.0);
  EXPECT_NEAR(drive.twist().omega, 0.5 * (2.5 - 2.0) / 2.25 / robot.wheel_separation, 1e-12);
  // The ramp is 4 m/s^2 of each rim: v^2 / 8 m are lost at 0.4444 and 0.5556 m/s, or v^2 / 8 / radius / 2 pi
  // revolutions.
  EXPECT_NEAR(drive.ticks().left - drive.ticks().right, 2578 * 0.00694 / 0.0762 / (2.0 * std::numbers::pi),
              2);
  EXPECT_GT(drive.ticks().left, 4000);
}

TEST(DriveModel, EncodersCountTheWay) {
  const Robot robot;  // 2578 ticks per 2 pi 0.0762 m
  DriveModel drive({}, robot, {}, Random(1));
  ASSERT_TRUE(drive.command(rim(robot, 0.5, 1.0)));
  run(drive, 20.0);
  // Ramps at 4 m/s^2 lose v^2 / (2 a): the left wheel rolls 10 - 0.03125 m, the right one 20 - 0.125 m.
  const double ticks_per_metre = 2578.0 / (2.0 * std::numbers::pi * 0.0762);
  EXPECT_NEAR(drive.ticks().left, std::floor(9.96875 * ticks_per_metre), 1.0);
  EXPECT_NEAR(drive.ticks().right, std::floor(19.875 * ticks_per_metre), 1.0);
}

TEST(DriveModel, CountersWrapAt32Bits) {
  const Robot robot;
  DriveOptions options;
  options.first_tick = std::numeric_limits<std::int32_t>::max();
  DriveModel drive(options, robot, {}, Random(1));
  EXPECT_EQ(drive.ticks().left, std::numeric_limits<std::int32_t>::max());
  ASSERT_TRUE(drive.command(rim(robot, 0.2, -0.2)));
  run(drive, 1.0);
  EXPECT_LT(drive.ticks().left, 0);
  EXPECT_GT(drive.ticks().right, 2147480000);
}

TEST(DriveModel, EncodersErrByScaleAndMismatch) {
  // model/README.md 2.2: the right wheel counts 1 + scale + e / 2, the left 1 + scale - e / 2 of its travel.
  const Robot robot;
  DriveOptions options;
  options.scale = 0.01;
  options.mismatch = 0.0085;
  DriveModel drive(options, robot, {}, Random(1));
  ASSERT_TRUE(drive.command(rim(robot, 1.0, 1.0)));
  run(drive, 100.125);  // 0.25 s ramp loses 0.125 m
  const double ticks = 100.0 * 2578.0 / (2.0 * std::numbers::pi * 0.0762);
  EXPECT_NEAR(drive.pose().x, 100.0, 0.01);
  EXPECT_NEAR(drive.ticks().left / ticks, 1.01 - 0.00425, 2e-4);
  EXPECT_NEAR(drive.ticks().right / ticks, 1.01 + 0.00425, 2e-4);
  EXPECT_NEAR(static_cast<double>(drive.ticks().right - drive.ticks().left) / ticks, 0.0085,
              1e-6 + 0.0085 * 2e-3);
}

TEST(DriveModel, EncoderNoiseGrowsWithTheWay) {
  // model/README.md 2.2: variance k |s|. 400 seeds over 1 m with k = 2.5e-4: sample variance within five of
  // its standard errors.
  const Robot robot;
  DriveOptions options;
  options.noise = 2.5e-4;
  options.wheel_acceleration = 100.0;
  const double metres_per_tick = 2.0 * std::numbers::pi * 0.0762 / 2578.0;
  double sum = 0.0;
  double squares = 0.0;
  constexpr int kSeeds = 400;
  for (int seed = 0; seed < kSeeds; ++seed) {
    DriveModel drive(options, robot, {}, Random(static_cast<std::uint64_t>(seed)));
    ASSERT_TRUE(drive.command(rim(robot, 1.0, 1.0)));
    run(drive, 1.0);
    const double error = (drive.ticks().left + 0.5) * metres_per_tick - drive.pose().x;
    sum += error;
    squares += error * error;
  }
  EXPECT_NEAR(sum / kSeeds, 0.0, 5.0 * std::sqrt(2.5e-4 / kSeeds));
  EXPECT_NEAR(squares / kSeeds, 2.5e-4, 5.0 * 2.5e-4 * std::sqrt(2.0 / kSeeds));
}

TEST(DriveModel, SlipLosesWayThatEncodersStillCount) {
  const Robot robot;
  DriveOptions options;
  options.slip = 0.2;
  options.wheel_acceleration = 100.0;
  DriveModel drive(options, robot, {}, Random(1));
  ASSERT_TRUE(drive.command(rim(robot, 1.0, 1.0)));
  run(drive, 10.0);
  EXPECT_NEAR(drive.twist().v, 0.8, 1e-12);
  const double counted = drive.ticks().left * 2.0 * std::numbers::pi * 0.0762 / 2578.0;
  EXPECT_NEAR(drive.pose().x / counted, 0.8, 1e-4);
}

TEST(DriveModel, AWallStopsTheDiscButLetsItTurnAndLeave) {
  const Robot robot;  // radius 0.3
  const StaticScene wall({{}, {}, {{{2.0, -5.0}, {2.0, 5.0}}}}, std::nullopt);
  DriveModel drive({}, robot, {}, Random(1));
  ASSERT_TRUE(drive.command(rim(robot, 1.0, 1.0)));
  run(drive, 5.0, wall);
  EXPECT_LE(drive.pose().x, 1.7);
  EXPECT_GT(drive.pose().x, 1.7 - 0.01);  // one step of 1 m/s
  const EncoderTicks stalled = drive.ticks();
  run(drive, 1.0, wall);
  EXPECT_NEAR(drive.ticks().left, stalled.left, 60) << "stalled wheels do not count";  // 1 cm is 54 ticks
  ASSERT_TRUE(drive.command(rim(robot, -0.3, 0.3)));
  run(drive, 1.0, wall);
  EXPECT_GT(drive.pose().theta, 1.0);
  ASSERT_TRUE(drive.command(rim(robot, -0.5, -0.5)));
  run(drive, 0.2, wall);
  ASSERT_TRUE(drive.command(rim(robot, 1.0, 1.0)));
  run(drive, 1.0, wall);
  EXPECT_LE(drive.pose().x, 1.7);
}

TEST(DriveModel, BrakesOnACommandThatIsNotFinite) {
  const Robot robot;
  DriveModel drive({}, robot, {}, Random(1));
  ASSERT_TRUE(drive.command(rim(robot, 1.0, 1.0)));
  run(drive, 1.0);
  EXPECT_FALSE(drive.command({std::nan(""), 1.0}));
  run(drive, 1.0);
  EXPECT_EQ(drive.twist().v, 0.0);
  EXPECT_FALSE(drive.command({1.0, std::numeric_limits<double>::infinity()}));
  EXPECT_TRUE(is_finite(drive.pose()));
}

}  // namespace
}  // namespace bw
