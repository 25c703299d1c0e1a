#include "components/lab/experiments/range_start.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "components/model/random.hpp"

namespace bw {
namespace {

/// A robot that drives straight on with 0.5 m/s from X_MO, four anchors in turn at 10 Hz.
RecordedDrive straight(const Pose2& X_MO, double noise, bool outliers, std::uint64_t seed) {
  const Vector2 anchors[] = {{0.0, 0.0}, {5.0, 0.0}, {5.0, 5.0}, {0.0, 5.0}};
  Random random(seed);
  RecordedDrive drive;
  for (int i = 0; i < 60; ++i) {
    const Time time = Time::seconds(i / 10.0);
    const Pose2 X_OB{0.05 * i, 0.0, 0.0};
    drive.odometry.push_back({time, X_OB, {0.5, 0.0}});
    const Vector2 anchor = anchors[i % 4];
    double range = (X_MO * X_OB.position() - anchor).norm() + noise * random.normal();
    if (outliers && i % 7 == 3) range += 2.0;
    drive.ranges.push_back({time, anchor, range, noise * noise});
  }
  return drive;
}

void expect_found(bool outliers) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Random random(seed + 1000);
    const Pose2 X_MO{random.uniform(1.5, 3.5), random.uniform(1.5, 3.5), random.uniform(-3.1, 3.1)};
    const RecordedDrive drive = straight(X_MO, 0.05, outliers, seed);
    const auto start = range_start(drive, 0.2);
    ASSERT_TRUE(start) << seed;
    const Pose2 X_MB = X_MO * Pose2{0.5 * start->time.to_seconds(), 0.0, 0.0};
    const Eigen::Vector3d error(start->X_MB.x - X_MB.x, start->X_MB.y - X_MB.y,
                                wrap_angle(start->X_MB.theta - X_MB.theta));
    EXPECT_LE(start->covariance(2, 2), 0.04);
    // Twice the standard deviation that it claims is four of the noise's (its variance is fourfold).
    for (int i = 0; i < 3; ++i)
      EXPECT_LT(std::abs(error(i)), 2.0 * std::sqrt(start->covariance(i, i))) << seed;
  }
}

TEST(RangeStart, FindsPositionAndHeading) { expect_found(false); }

// One range in seven 2 m too long.
TEST(RangeStart, OutliersHardlyMoveIt) { expect_found(true); }

TEST(RangeStart, AStandingRobotHasNoHeading) {
  RecordedDrive drive = straight({2.0, 2.0, 0.3}, 0.05, false, 1);
  for (OdometrySample& sample : drive.odometry) sample.X_OB = {};
  for (RangeSample& range : drive.ranges) range.range = (Vector2(2.0, 2.0) - range.anchor).norm();
  EXPECT_FALSE(range_start(drive, 0.2));
}

}  // namespace
}  // namespace bw
