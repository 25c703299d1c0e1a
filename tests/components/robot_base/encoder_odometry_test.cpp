#include "components/robot_base/encoder_odometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "components/model/random.hpp"

namespace bw {
namespace {

constexpr double kPi = std::numbers::pi;

Robot fast_robot() {
  Robot robot;
  robot.limits.v_max = 5.0;
  robot.limits.omega_max = 10.0;
  return robot;
}

double metres_per_tick(const Robot& robot) {
  return 2.0 * kPi * robot.wheel_radius / static_cast<double>(robot.ticks_per_revolution);
}

/// Adds `steps` readings 20 ms apart, each a whole number of ticks further.
void drive(EncoderOdometry& odometry, EncoderCounts& counts, std::int32_t left, std::int32_t right,
           int steps) {
  for (int i = 0; i < steps; ++i) {
    counts.time = counts.time + Duration::milliseconds(20);
    counts.left =
        static_cast<std::int32_t>(static_cast<std::uint32_t>(counts.left) + static_cast<std::uint32_t>(left));
    counts.right = static_cast<std::int32_t>(static_cast<std::uint32_t>(counts.right) +
                                             static_cast<std::uint32_t>(right));
    ASSERT_EQ(odometry.add(counts.time, counts), CountsStatus::moved);
  }
}

/// Pose after travelling an arc of length s and rotation phi from the origin: (R sin phi, R (1 - cos phi),
/// phi), R = s / phi.
Pose2 arc_end(double s, double phi) {
  if (phi == 0.0) return {s, 0.0, 0.0};
  return {s / phi * std::sin(phi), s / phi * (1.0 - std::cos(phi)), wrap_angle(phi)};
}

TEST(EncoderOdometry, LoopsOfAnyCurvatureMatchTheClosedFormWithin1e9) {
  const Robot robot = fast_robot();
  const double tick = metres_per_tick(robot);
  for (const auto& [left, right] :
       {std::pair{100, 130}, {130, 100}, {-90, 90}, {200, 200}, {-50, -80}, {0, 37}}) {
    EncoderOdometry odometry(robot, {});
    EncoderCounts counts{Time::seconds(1.0), 0, 0};
    odometry.add(counts.time, counts);
    const double rotation_per_step = (right - left) * tick / robot.wheel_separation;
    const int steps = right == left ? 5000 : static_cast<int>(2.0 * kPi / std::abs(rotation_per_step)) + 1;
    drive(odometry, counts, left, right, steps);
    const double s = (left + right) / 2.0 * tick * steps;
    const Pose2 expected = arc_end(s, rotation_per_step * steps);
    EXPECT_NEAR(odometry.state().X_OB.x, expected.x, 1e-9) << left << ' ' << right;
    EXPECT_NEAR(odometry.state().X_OB.y, expected.y, 1e-9) << left << ' ' << right;
    EXPECT_NEAR(wrap_angle(odometry.state().X_OB.theta - expected.theta), 0.0, 1e-9);
  }
}

TEST(EncoderOdometry, WheelsOfTwoSizesTravelByTheirOwn) {
  // Right 1 % larger: radii r 2 / 2.01 and r 2.02 / 2.01. The same ticks of both give travels in that ratio,
  // r as their mean, and an arc to the left.
  Robot robot = fast_robot();
  robot.wheel_radius_ratio = 1.01;
  EncoderOdometry odometry(robot, {});
  EncoderCounts counts{Time::seconds(1.0), 0, 0};
  odometry.add(counts.time, counts);
  drive(odometry, counts, 100, 100, 100);
  const double mean = 10'000 * metres_per_tick(robot);
  const double rotation = mean * (2.02 - 2.0) / 2.01 / robot.wheel_separation;
  const Pose2 expected = arc_end(mean, rotation);
  EXPECT_NEAR(odometry.state().X_OB.x, expected.x, 1e-9);
  EXPECT_NEAR(odometry.state().X_OB.y, expected.y, 1e-9);
  EXPECT_NEAR(odometry.state().X_OB.theta, expected.theta, 1e-12);
  // The wheels' angles are those of their counts, whatever their sizes.
  const double angle = 10'000.0 / static_cast<double>(robot.ticks_per_revolution) * 2.0 * kPi;
  EXPECT_NEAR(odometry.state().left_angle, angle, 1e-9);
  EXPECT_NEAR(odometry.state().right_angle, angle, 1e-9);
}

TEST(EncoderOdometry, SquareOfFiveMetresClosesWithinTheTickRounding) {
  // UMBmark square with whole ticks: the four straights cancel up to the heading error of a corner's
  // rounding.
  const Robot robot = fast_robot();
  EncoderOdometry odometry(robot, {});
  EncoderCounts counts{Time::seconds(1.0), 0, 0};
  odometry.add(counts.time, counts);
  const double tick = metres_per_tick(robot);
  const int straight = static_cast<int>(std::lround(5.0 / tick / 100.0));
  const int corner_ticks = static_cast<int>(std::lround(kPi / 2.0 * robot.wheel_separation / 2.0 / tick));
  for (int side = 0; side < 4; ++side) {
    drive(odometry, counts, 100, 100, straight);
    drive(odometry, counts, -corner_ticks / 50, corner_ticks / 50, 50);
    drive(odometry, counts, -(corner_ticks % 50), corner_ticks % 50, 1);
  }
  const double corner_error = std::abs(corner_ticks * tick * 2.0 / robot.wheel_separation - kPi / 2.0);
  EXPECT_LT(odometry.state().X_OB.position().norm(), 5.0 * 6.0 * corner_error + 1e-9);
}

TEST(EncoderOdometry, CountersWrapWithoutAStep) {
  EncoderOdometry odometry(fast_robot(), {});
  EncoderCounts counts{Time::seconds(1.0), std::numeric_limits<std::int32_t>::max() - 250,
                       std::numeric_limits<std::int32_t>::min() + 250};
  odometry.add(counts.time, counts);
  drive(odometry, counts, 100, 100, 10);
  drive(odometry, counts, -100, -100, 20);
  const double expected = -1000.0 * metres_per_tick(fast_robot());
  EXPECT_NEAR(odometry.state().X_OB.x, expected, 1e-12);
  EXPECT_EQ(odometry.faults().jumps, 0U);
  EXPECT_EQ(odometry.faults().resets, 0U);
}

TEST(EncoderOdometry, OneWildReadingIsDroppedAndNoMotionIsLost) {
  EncoderOdometry odometry(fast_robot(), {});
  EncoderCounts counts{Time::seconds(1.0), 100'000, 100'000};
  odometry.add(counts.time, counts);
  drive(odometry, counts, 100, 100, 5);
  EncoderCounts wild = counts;
  wild.time = counts.time + Duration::milliseconds(20);
  wild.left += 5'000'000;
  EXPECT_EQ(odometry.add(wild.time, wild), CountsStatus::jump);
  EXPECT_NEAR(odometry.state().X_OB.x, 500.0 * metres_per_tick(fast_robot()), 1e-12);

  counts.time = wild.time;
  counts.left += 100;
  counts.right += 100;
  drive(odometry, counts, 100, 100, 1);
  EXPECT_NEAR(odometry.state().X_OB.x, 700.0 * metres_per_tick(fast_robot()), 1e-12);
  EXPECT_NEAR(odometry.state().X_OB.theta, 0.0, 1e-12);
  EXPECT_EQ(odometry.faults().jumps, 1U);
}

TEST(EncoderOdometry, ARestartedEncoderBoardIsAResetAndOdometryGoesOn) {
  EncoderOdometry odometry(fast_robot(), {});
  EncoderCounts counts{Time::seconds(1.0), 700'000, 800'000};
  odometry.add(counts.time, counts);
  drive(odometry, counts, 100, 100, 5);
  counts = {counts.time + Duration::milliseconds(20), 3, 5};
  EXPECT_EQ(odometry.add(counts.time, counts), CountsStatus::reset);
  counts = {counts.time + Duration::milliseconds(20), 103, 105};
  EXPECT_EQ(odometry.add(counts.time, counts), CountsStatus::rebased);
  drive(odometry, counts, 100, 100, 4);
  // Five steps before and five after; the step lost in the restart is left out.
  EXPECT_NEAR(odometry.state().X_OB.x, 1000.0 * metres_per_tick(fast_robot()), 1e-12);
  EXPECT_NEAR(odometry.state().twist.v, 100.0 * metres_per_tick(fast_robot()) / 0.02, 1e-9);
  EXPECT_EQ(odometry.faults().resets, 1U);
  EXPECT_EQ(odometry.faults().jumps, 0U);
}

// A standing robot, and one bit of one reading or of two in a row that is wrong: the pose moves by no more
// than the wheels can rotate meanwhile, 2 ticks of rounding with it, and is back when the bit is. 2^31 counts
// beside has no magnitude of 32 bits.
TEST(EncoderOdometry, AFlippedBitMovesAStandingRobotNoFurtherThanItsWheelsCan) {
  const Robot robot;
  const OdometryOptions options;
  const double wheel_speed_max = std::max(robot.limits.v_max, robot.limits.v_back_max) +
                                 robot.limits.omega_max * robot.wheel_separation / 2.0;
  const double in_a_period = options.speed_margin * wheel_speed_max * 0.02 + 2.0 * metres_per_tick(robot);
  constexpr std::int32_t kLeast = std::numeric_limits<std::int32_t>::min();
  constexpr std::int32_t kMax = std::numeric_limits<std::int32_t>::max();
  for (const std::int32_t count : {0, 1, -1, 12'345, -1'000'000, kLeast, kLeast + 1, kMax}) {
    for (int flip = 0; flip < 3 * 32; ++flip) {  // of the left, the right, both
      for (const int wrong : {1, 2}) {
        const double most = wrong * in_a_period;
        EncoderOdometry odometry(robot, options);
        EncoderCounts counts{Time::seconds(1.0), count, count};
        odometry.add(counts.time, counts);
        drive(odometry, counts, 0, 0, 5);
        const auto flipped = static_cast<std::int32_t>(static_cast<std::uint32_t>(count) ^ 1U << flip % 32);
        for (int i = 0; i < wrong + 5; ++i) {
          counts.time = counts.time + Duration::milliseconds(20);
          counts.left = i < wrong && flip / 32 != 1 ? flipped : count;
          counts.right = i < wrong && flip / 32 != 0 ? flipped : count;
          odometry.add(counts.time, counts);
          const Pose2& pose = odometry.state().X_OB;
          ASSERT_LE(std::hypot(pose.x, pose.y), most) << count << " bit " << flip << " reading " << i;
          ASSERT_LE(std::abs(pose.theta), 2.0 * most / robot.wheel_separation) << count << " bit " << flip;
          ASSERT_TRUE(std::isfinite(odometry.state().twist.v));
        }
        ASSERT_NEAR(odometry.state().X_OB.x, 0.0, 1e-9) << count << " bit " << flip;
      }
    }
  }
}

TEST(EncoderOdometry, LimitOfThePossibleIsTheMarginTimesTheTopWheelSpeed) {
  const Robot robot;  // top wheel speed 1 + 1 * 0.39 / 2 = 1.195 m/s, margin 2: 2.39 m/s, 47.8 mm in 20 ms
  const double tick = metres_per_tick(robot);
  const int reach = static_cast<int>(2.39 * 0.02 / tick);
  for (const int ticks : {reach, -reach, reach + 4, -reach - 4}) {
    EncoderOdometry odometry(robot, {});
    odometry.add(Time::seconds(1.0), {Time::seconds(1.0), 50'000, 50'000});
    const CountsStatus status =
        odometry.add(Time::seconds(1.02), {Time::seconds(1.02), 50'000 + ticks, 50'000});
    EXPECT_EQ(status, std::abs(ticks) <= reach ? CountsStatus::moved : CountsStatus::jump) << ticks;
  }
}

TEST(EncoderOdometry, RepeatedAndOldStampsAreCountedAndIgnored) {
  EncoderOdometry odometry(fast_robot(), {});
  EncoderCounts counts{Time::seconds(1.0), 0, 0};
  EXPECT_EQ(odometry.add(counts.time, counts), CountsStatus::first);
  drive(odometry, counts, 10, 10, 3);
  EXPECT_EQ(odometry.add(counts.time, counts), CountsStatus::stale);
  EXPECT_EQ(odometry.add(counts.time, {counts.time - Duration::milliseconds(20), 0, 0}), CountsStatus::stale);
  EXPECT_EQ(odometry.faults().stale, 2U);
  EXPECT_NEAR(odometry.state().X_OB.x, 30.0 * metres_per_tick(fast_robot()), 1e-12);
}

// However many, and however they rise: what was read 5 s ago and is sent again moves nothing.
TEST(EncoderOdometry, OldReadingsSentAgainAreNoMotion) {
  EncoderOdometry odometry(fast_robot(), {});
  EncoderCounts counts{Time::seconds(10.0), 0, 0};
  odometry.add(counts.time, counts);
  drive(odometry, counts, 10, 10, 5);
  EncoderCounts old{Time::seconds(5.0), 0, 0};
  for (int i = 0; i < 20; ++i) {
    old.time = old.time + Duration::milliseconds(20);
    old.left -= 10;
    EXPECT_EQ(odometry.add(counts.time, old), CountsStatus::stale);
  }
  drive(odometry, counts, 10, 10, 5);
  EXPECT_NEAR(odometry.state().X_OB.x, 100.0 * metres_per_tick(fast_robot()), 1e-12);
}

// What the base went between the two readings is not known.
TEST(EncoderOdometry, GoesOnFromTheFirstReadingAfterTheClockWentBack) {
  EncoderOdometry odometry(fast_robot(), {});
  EncoderCounts counts{Time::seconds(10.0), 0, 0};
  odometry.add(counts.time, counts);
  drive(odometry, counts, 10, 10, 5);
  // One that was stamped before is on its way still.
  EncoderCounts late = counts;
  late.time = late.time + Duration::milliseconds(20);
  counts = {counts.time - Duration::seconds(5.0), counts.left + 10, counts.right + 10};
  EXPECT_EQ(odometry.add(counts.time, late), CountsStatus::moved);
  EXPECT_EQ(odometry.add(counts.time, counts), CountsStatus::rebased);
  drive(odometry, counts, 10, 10, 5);
  EXPECT_EQ(odometry.state().time, counts.time);
  EXPECT_NEAR(odometry.state().X_OB.x, 100.0 * metres_per_tick(fast_robot()), 1e-12);  // without the one
  EXPECT_NEAR(odometry.state().twist.v, 10.0 * metres_per_tick(fast_robot()) / 0.02, 1e-9);
}

TEST(EncoderOdometry, TwistIsTheMeanOverTheWindow) {
  const Robot robot = fast_robot();
  EncoderOdometry odometry(robot, {.velocity_window = 0.06});
  EncoderCounts counts{Time::seconds(1.0), 0, 0};
  odometry.add(counts.time, counts);
  drive(odometry, counts, 100, 100, 10);
  drive(odometry, counts, 160, 220, 1);
  // Three intervals of 20 ms: mean of 100, 100 and 190 ticks; rotation of 60 ticks over 60 ms.
  const double tick = metres_per_tick(robot);
  EXPECT_NEAR(odometry.state().twist.v, 390.0 * tick / 0.06, 1e-9);
  EXPECT_NEAR(odometry.state().twist.omega, 60.0 * tick / robot.wheel_separation / 0.06, 1e-9);
}

TEST(EncoderOdometry, CovarianceOfAStraightDriveIsTheClosedForm) {
  // n steps of ds, q = k ds per wheel: var(theta) = 2 n q / b^2, var(x) = n q / 2, and var(y) = sum over
  // steps of (2 q / b^2) (lever to the end)^2, lever = (n - i - 1/2) ds.
  const Robot robot = fast_robot();
  const double k = 2.5e-4;
  EncoderOdometry odometry(robot, {.variance_per_metre = k});
  EncoderCounts counts{Time::seconds(1.0), 0, 0};
  odometry.add(counts.time, counts);
  const int n = 200;
  drive(odometry, counts, 100, 100, n);
  const double ds = 100.0 * metres_per_tick(robot);
  const double q = k * ds;
  const double b2 = robot.wheel_separation * robot.wheel_separation;
  double var_y = 0.0;
  for (int i = 0; i < n; ++i) var_y += 2.0 * q / b2 * std::pow((n - i - 0.5) * ds, 2);
  const Eigen::Matrix3d& P = odometry.state().pose_covariance;
  EXPECT_NEAR(P(0, 0), n * q / 2.0, 1e-12);
  EXPECT_NEAR(P(1, 1), var_y, 1e-9);
  EXPECT_NEAR(P(2, 2), 2.0 * n * q / b2, 1e-12);
  EXPECT_NEAR(P(1, 2), P(2, 1), 1e-15);
}

TEST(EncoderOdometry, CovarianceMatchesTheSpreadOfSimulatedWheelNoise) {
  // 2,000 drives on a quarter circle with wheel noise N(0, k |ds|): the sample covariance agrees within its
  // own spread (about 3 * sqrt(2 / n)).
  Robot robot = fast_robot();
  robot.ticks_per_revolution = 10'000'000;
  const double k = 1e-3;
  const double tick = metres_per_tick(robot);
  const int steps = 60;
  const double ds_left = 0.02;
  const double ds_right = ds_left + kPi / 2.0 * robot.wheel_separation / steps;
  constexpr std::uint64_t kSeed = 11;
  Random random(kSeed);
  constexpr int kRuns = 2000;
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  EncoderOdometry nominal(robot, {.variance_per_metre = k});
  for (int run = -1; run < kRuns; ++run) {
    EncoderOdometry odometry(robot, {.variance_per_metre = k, .speed_margin = 100.0});
    double left = 0.0;
    double right = 0.0;
    for (int i = 0; i <= steps; ++i) {
      const EncoderCounts counts{Time::seconds(1.0 + 0.02 * i),
                                 static_cast<std::int32_t>(std::lround(left / tick)),
                                 static_cast<std::int32_t>(std::lround(right / tick))};
      (run < 0 ? nominal : odometry).add(counts.time, counts);
      left += ds_left + (run < 0 ? 0.0 : random.normal(0.0, std::sqrt(k * ds_left)));
      right += ds_right + (run < 0 ? 0.0 : random.normal(0.0, std::sqrt(k * ds_right)));
    }
    if (run < 0) continue;
    const Pose2& X = odometry.state().X_OB;
    const Pose2& X0 = nominal.state().X_OB;
    const Eigen::Vector3d e(X.x - X0.x, X.y - X0.y, wrap_angle(X.theta - X0.theta));
    sum += e * e.transpose();
  }
  const Eigen::Matrix3d sample = sum / kRuns;
  const Eigen::Matrix3d& P = nominal.state().pose_covariance;
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(sample(i, i) / P(i, i), 1.0, 0.12) << "axis " << i << " seed " << kSeed;
}

TEST(EncoderOdometry, WheelAnglesForJointStates) {
  const Robot robot = fast_robot();
  EncoderOdometry odometry(robot, {});
  EncoderCounts counts{Time::seconds(1.0), 0, 0};
  odometry.add(counts.time, counts);
  drive(odometry, counts, 100, -50, 50);
  const double rad_per_tick = 2.0 * kPi / static_cast<double>(robot.ticks_per_revolution);
  EXPECT_NEAR(odometry.state().left_angle, 5000.0 * rad_per_tick, 1e-9);
  EXPECT_NEAR(odometry.state().right_angle, -2500.0 * rad_per_tick, 1e-9);
}

}  // namespace
}  // namespace bw
