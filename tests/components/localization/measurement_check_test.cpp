#include "components/localization/measurement_check.hpp"

#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "components/model/random.hpp"
#include "components/model/wheel_step.hpp"

namespace bw::localization {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
const MeasurementLimits kLimits;

WheelStep wheels(double distance, double rotation) {
  return step_from_wheels(Time{0}, Duration::milliseconds(100), distance - 0.2 * rotation,
                          distance + 0.2 * rotation, 0.4, 1e-3);
}

TEST(MeasurementCheck, SoundOnesPass) {
  EXPECT_EQ(check(wheels(0.1, 0.05), kLimits), Verdict::accepted);
  EXPECT_EQ(check(wheels(0.0, 0.0), kLimits), Verdict::accepted);  // stands: covariance zero
  EXPECT_EQ(check(wheels(0.1, 0.5), kLimits), Verdict::accepted);  // one wheel stands: singular
  EXPECT_EQ(check(GyroReading{}, kLimits), Verdict::accepted);
  EXPECT_EQ(check(PositionFix{}, kLimits), Verdict::accepted);
  EXPECT_EQ(check(PoseReading{}, kLimits), Verdict::accepted);
  EXPECT_EQ(check(HeadingReading{}, kLimits), Verdict::accepted);
  EXPECT_EQ(check(CourseReading{}, kLimits), Verdict::accepted);
}

TEST(MeasurementCheck, NamesTheFault) {
  PositionFix fix;
  fix.position.x() = kNan;
  EXPECT_EQ(check(fix, kLimits), Verdict::not_finite);
  fix.position.x() = 2e6;
  EXPECT_EQ(check(fix, kLimits), Verdict::implausible);
  fix = {};
  fix.covariance(0, 1) = kInfinity;
  EXPECT_EQ(check(fix, kLimits), Verdict::not_finite);
  fix.covariance << 1.0, 0.2, 0.0, 1.0;  // not symmetric
  EXPECT_EQ(check(fix, kLimits), Verdict::bad_covariance);
  fix.covariance << 1.0, 1.1, 1.1, 1.0;  // eigenvalues 2.1, -0.1
  EXPECT_EQ(check(fix, kLimits), Verdict::bad_covariance);
  fix.covariance = Eigen::Matrix2d::Zero();
  EXPECT_EQ(check(fix, kLimits), Verdict::bad_covariance);
  fix.covariance = 1.1e6 * Eigen::Matrix2d::Identity();
  EXPECT_EQ(check(fix, kLimits), Verdict::bad_covariance);
  fix = {};
  fix.source = 8;
  EXPECT_EQ(check(fix, kLimits, 8), Verdict::bad_source);
  EXPECT_EQ(check(fix, kLimits, 9), Verdict::accepted);
  fix.source = -1;
  EXPECT_EQ(check(fix, kLimits), Verdict::bad_source);

  HeadingReading heading;
  heading.variance = 0.0;
  EXPECT_EQ(check(heading, kLimits), Verdict::bad_covariance);
  heading.variance = kNan;
  EXPECT_EQ(check(heading, kLimits), Verdict::not_finite);
  heading.heading = 1e300;
  EXPECT_EQ(check(heading, kLimits), Verdict::implausible);

  RangeReading range;
  EXPECT_EQ(check(range, kLimits), Verdict::accepted);
  range.range = -0.1;
  EXPECT_EQ(check(range, kLimits), Verdict::implausible);
  range.range = kNan;
  EXPECT_EQ(check(range, kLimits), Verdict::not_finite);
  range.range = 1.0;
  range.anchor.y() = kInfinity;
  EXPECT_EQ(check(range, kLimits), Verdict::not_finite);
  range.anchor.y() = 0.0;
  range.variance = 0.0;
  EXPECT_EQ(check(range, kLimits), Verdict::bad_covariance);

  GyroReading gyro;
  gyro.rate = 21.0;
  EXPECT_EQ(check(gyro, kLimits), Verdict::implausible);

  WheelStep step = wheels(0.1, 0.0);
  step.over = Duration{0};
  EXPECT_EQ(check(step, kLimits), Verdict::bad_interval);
  step.over = Duration::milliseconds(1001);
  EXPECT_EQ(check(step, kLimits), Verdict::bad_interval);
  step = wheels(2.1, 0.0);  // 21 m/s
  EXPECT_EQ(check(step, kLimits), Verdict::implausible);
  step = wheels(0.1, 0.0);
  step.covariance(0, 0) = -1e-9;
  EXPECT_EQ(check(step, kLimits), Verdict::bad_covariance);
  // Small beside the distance's variance, and yet no covariance: an eigenvalue of its symmetric part is
  // -0.027.
  step.covariance << 1e6, 0.0, 0.33, 1e-10;
  EXPECT_EQ(check(step, kLimits), Verdict::bad_covariance);
}

// The oracle is the eigenvalues; matrices within 1e-9 of singular may go either way.
TEST(MeasurementCheck, TellsPositiveDefiniteByEigenvalues) {
  Random random(4);
  int sound = 0;
  for (int i = 0; i < 20000; ++i) {
    PoseReading pose;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c <= r; ++c)
        pose.covariance(r, c) = pose.covariance(c, r) = (r == c ? 1.0 : 0.8) * random.normal();
    pose.covariance.diagonal() = pose.covariance.diagonal().cwiseAbs();
    const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(pose.covariance).eigenvalues()(0);
    if (std::abs(least) < 1e-9) continue;
    sound += least > 0.0 ? 1 : 0;
    ASSERT_EQ(check(pose, kLimits) == Verdict::accepted, least > 0.0) << pose.covariance;
  }
  EXPECT_GT(sound, 1000);  // both sides are met
}

}  // namespace
}  // namespace bw::localization
