// Ranges to anchors, and courses from fixes: positions and headings without a receiver's fix or a compass.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "components/localization/course_from_fixes.hpp"
#include "components/localization/ekf/ekf.hpp"
#include "tests/components/localization/simulated_drive.hpp"

namespace bw::localization {
namespace {

constexpr int kRanges = 6;
constexpr double kRangeSigma = 0.1;
const Vector2 kAnchors[] = {{-10, -10}, {60, -10}, {60, 40}, {-10, 40}};

bool has(const Health& health, HealthCause cause) {
  for (const HealthReason& reason : health.reasons)
    if (reason.cause == cause) return true;
  return false;
}

// Range to the anchors in turn, 10 Hz.
RangeReading range_at(const Drive& drive, int step, Random& random) {
  RangeReading m;
  m.time = step_time(step);
  m.source = kRanges;
  m.anchor = kAnchors[step / 10 % 4];
  m.variance = kRangeSigma * kRangeSigma;
  const Vector2 position = drive.truth[static_cast<std::size_t>(step)].position();
  m.range = (position - m.anchor).norm() + kRangeSigma * random.normal();
  return m;
}

// P = 0.25 along the line to the anchor, R = 0.75: S = 1, and the gate of one degree of freedom at 99.9 %
// lies at sqrt(10.8276) = 3.29053 m.
TEST(EkfRange, GateLiesAtTheQuantile) {
  for (const double beyond : {3.2900, 3.2911}) {
    Ekf ekf({});
    ASSERT_TRUE(ekf.start_at({}, Eigen::Vector3d(0.25, 0.25, 0.01).asDiagonal(), kStart));
    const RangeReading m{kStart, kRanges, 5.0 + beyond, 0.75, {-5.0, 0.0}, {0.0, 0.0}};
    const Verdict verdict = ekf.add(m, kStart).verdict;
    EXPECT_EQ(verdict, beyond < 3.2905 ? Verdict::accepted : Verdict::gated);
    if (used(verdict)) {
      EXPECT_NEAR(ekf.state().x(0), 0.25 * beyond, 1e-6);  // the scalar filter
      EXPECT_EQ(ekf.state().x(1), 0.0);
    }
  }
}

// Wheels, gyro and ranges of 0.1 m: the error stays below three times that of one range, the state OK; the
// first pose is given, 1 m off.
TEST(EkfRange, FourAnchorsReplaceAReceiver) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    DriveOptions options;
    options.seed = seed;
    options.gps_sigma = options.compass_sigma = 0.0;
    const Drive drive = simulate(options);
    Random random(seed);
    Ekf ekf({});
    ASSERT_TRUE(ekf.start_at({1.0, 0.0, 0.0}, Eigen::Vector3d(1.0, 1.0, 0.04).asDiagonal(), kStart));
    int step = 0;
    for (const Measurement& m : drive.measurements) {
      ekf.add(m, stamp(m));
      if (!std::holds_alternative<WheelStep>(m)) continue;
      if (++step % 10 == 0) ekf.add(range_at(drive, step, random), stamp(m));
      if (step < 2000) continue;
      const Vector2 error =
          ekf.estimate().X_MB.position() - drive.truth[static_cast<std::size_t>(step)].position();
      ASSERT_LT(error.norm(), 0.3) << seed << " " << step;
    }
    EXPECT_EQ(ekf.health(step_time(6000)).state, HealthState::ok);
  }
}

// 10 m too long from 20 s on: the share accepted falls below a half within 35 ranges (1 - 1/50 each), 3.5 s;
// contradicted for 3 s more: LOST before 27 s. While they fit, a receiver 30 m off makes nothing LOST and
// takes nothing over.
TEST(EkfRange, RangesCountAsPositionsWhileMostFit) {
  for (const bool ranges_fail : {true, false}) {
    DriveOptions options;
    options.compass_sigma = 0.0;
    const Drive drive = simulate(options);
    Random random(1);
    Ekf ekf({});
    ASSERT_TRUE(ekf.start_at({}, 0.01 * Eigen::Matrix3d::Identity(), kStart));
    double lost = 0.0;
    int step = 0;
    for (Measurement m : drive.measurements) {
      auto* fix = std::get_if<PositionFix>(&m);
      if (fix != nullptr && ranges_fail) continue;
      if (fix != nullptr && step >= 2000) fix->position.x() += 30.0;
      ASSERT_NE(ekf.add(m, stamp(m)).verdict, Verdict::reacquired);
      if (!std::holds_alternative<WheelStep>(m) || ++step % 10 != 0) continue;
      RangeReading range = range_at(drive, step, random);
      if (ranges_fail && step > 2000) range.range += 10.0;
      ekf.add(range, stamp(m));
      const Health health = ekf.health(stamp(m));
      if (lost == 0.0 && has(health, HealthCause::contradicted)) lost = step * 0.01;
      if (step == 2000) {
        ASSERT_EQ(health.state, HealthState::ok);
      }
    }
    if (ranges_fail) {
      EXPECT_GT(lost, 23.0);
      EXPECT_LT(lost, 27.0);
    } else {
      EXPECT_EQ(lost, 0.0);
    }
  }
}

// Two fixes of standard deviation s, d apart: the course errs by sqrt(2) s / d.
TEST(CourseFromFixes, HasTheVarianceOfTwoFixesOverTheirDistance) {
  CourseFromFixes courses(7, {});
  PositionFix fix;
  fix.time = kStart;
  fix.covariance = 0.01 * Eigen::Matrix2d::Identity();
  EXPECT_FALSE(courses.add(fix));
  fix.time = kStart + Duration::milliseconds(200);
  fix.position = {0.0, 0.4};  // sqrt(0.02) / 0.4 = 0.35 > 0.3: not yet
  EXPECT_FALSE(courses.add(fix));
  fix.time = kStart + Duration::milliseconds(400);
  fix.position = {0.0, 0.8};
  const auto course = courses.add(fix);
  ASSERT_TRUE(course);
  EXPECT_NEAR(course->course, std::numbers::pi / 2.0, 1e-12);
  EXPECT_NEAR(course->variance, 0.02 / 0.64, 1e-12);
  EXPECT_EQ(course->time, kStart + Duration::milliseconds(200));
  fix.time = fix.time + Duration::milliseconds(2900);
  fix.position.x() += 0.8;  // 0.28 m/s: too slow
  EXPECT_FALSE(courses.add(fix));
}

// No compass, no gyro, and a start that is 0.6 rad off: courses alone (fixes are not given to the filter)
// bring the heading within 0.15 rad in 20 s.
TEST(CourseFromFixes, FindTheHeadingWithoutACompass) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    DriveOptions options;
    options.seed = seed;
    options.seconds = 20.0;
    options.gps_sigma = 0.1;
    options.gyro_sigma = options.compass_sigma = 0.0;
    const Drive drive = simulate(options);
    CourseFromFixes courses(7, {});
    Ekf ekf({});
    ASSERT_TRUE(ekf.start_at({0.0, 0.0, 0.6}, Eigen::Vector3d(0.01, 0.01, 0.36).asDiagonal(), kStart));
    int accepted = 0;
    for (const Measurement& m : drive.measurements) {
      const auto* fix = std::get_if<PositionFix>(&m);
      if (fix == nullptr) {
        ekf.add(m, stamp(m));
      } else if (const auto course = courses.add(*fix)) {
        accepted += used(ekf.add(*course, stamp(m)).verdict) ? 1 : 0;
      }
    }
    EXPECT_GT(accepted, 15) << seed;
    EXPECT_LT(std::abs(wrap_angle(ekf.estimate().X_MB.theta - drive.truth.back().theta)), 0.25) << seed;
  }
}

TEST(EkfOptionsRule, NamesCombinationsThatMakeNoSense) {
  EXPECT_FALSE(EkfOptions{}.violated_rule().has_value());
  EkfOptions options;
  options.motion.extrapolation = 0.05;
  EXPECT_TRUE(options.violated_rule().has_value());
  options = {};
  options.gate.reacquire_after = 1.0;
  EXPECT_TRUE(options.violated_rule().has_value());
}

}  // namespace
}  // namespace bw::localization
