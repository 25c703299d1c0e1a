// Angles that wrap, memory, kinds of sources, courses.
#include <cmath>
#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include "components/localization/ekf/ekf.hpp"
#include "tests/components/localization/simulated_drive.hpp"

namespace {
long allocations = 0;
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace bw::localization {
namespace {

// A thousand crossings of +-pi, half of them rotating in place: no step of the heading beyond three
// standard deviations of its own (localization/evidence.md 9.3).
TEST(EkfRobustness, HeadingCrossesPiAThousandTimesWithoutAJump) {
  DriveOptions options;
  options.seconds = 20.0;
  options.gps_sigma = 0.5;
  Random random(6);
  Ekf ekf({});
  ASSERT_TRUE(ekf.start_at({0, 0, 3.0}, 0.01 * Eigen::Matrix3d::Identity(), kStart));
  Pose2 X{0, 0, 3.0};
  int crossings = 0;
  Time now = kStart;
  for (int i = 1; crossings < 1000; ++i) {
    const Twist2 twist{crossings % 2 == 0 ? 0.0 : 0.5, crossings % 4 < 2 ? 15.0 : -15.0};
    const Pose2 next = advance_exact(X, twist, 0.01);
    if (std::abs(next.theta - X.theta) > 3.0) ++crossings;
    X = next;
    now = now + kStep;
    const double before = ekf.estimate().X_MB.theta;
    WheelStep step = step_from_twist(now, kStep, twist, Eigen::Vector2d(0.01, 0.01).asDiagonal());
    step.rotation += 1e-3 * random.normal();
    ASSERT_EQ(ekf.add(step, now).verdict, Verdict::accepted);
    ASSERT_NE(
        ekf.add(HeadingReading{now, kCompass, wrap_angle(X.theta + 0.05 * random.normal()), 0.0025}, now)
            .verdict,
        Verdict::reacquired);
    const Estimate e = ekf.estimate();
    const double jump = wrap_angle(e.X_MB.theta - before - twist.omega * 0.01);
    ASSERT_LT(std::abs(jump), 3.0 * std::sqrt(e.covariance(2, 2)) + 0.003) << i;
    ASSERT_LT(std::abs(wrap_angle(e.X_MB.theta - X.theta)), 0.1) << i;
  }
}

TEST(EkfRobustness, TakesNoMemoryAfterTheFirstPose) {
  DriveOptions options;
  options.seconds = 20.0;
  const Drive drive = simulate(options);
  Ekf ekf({});
  std::size_t i = 0;
  while (!ekf.initialised()) {
    ekf.add(drive.measurements[i], stamp(drive.measurements[i]));
    ++i;
  }
  const long before = allocations;
  Time now{};
  for (; i < drive.measurements.size(); ++i) {
    Measurement m = drive.measurements[i];
    now = std::max(now, stamp(m));
    ekf.add(m, now);
    if (i % 10 == 0 && i > 1000) ekf.add(drive.measurements[i - 300], now);  // late: a duplicate
  }
  EXPECT_EQ(allocations - before, 0);
}

TEST(EkfRobustness, ASourceKeepsItsKind) {
  Ekf ekf({});
  EXPECT_EQ(ekf.add(GyroReading{kStart, 3, 0.0, 1.0}, kStart).verdict, Verdict::collected);
  EXPECT_EQ(ekf.add(HeadingReading{kStart, 3, 0.0, 1.0}, kStart).verdict, Verdict::bad_source);
}

// While driving backward the course is opposite to the heading.
TEST(EkfCourse, IsTheHeadingForwardAndItsOppositeBackward) {
  for (const double v : {1.0, -1.0, 0.1}) {
    Ekf ekf({});
    ASSERT_TRUE(ekf.start_at({0, 0, 0.5}, 0.01 * Eigen::Matrix3d::Identity(), kStart));
    const Time now = kStart + kStep;
    ekf.add(step_from_twist(now, kStep, {v, 0.0}, 1e-4 * Eigen::Matrix2d::Identity()), now);
    CourseReading course{now, 4, wrap_angle(v > 0.0 ? 0.6 : 0.6 + 3.14159265358979), 0.01};
    const Verdict verdict = ekf.add(course, now).verdict;
    if (v == 0.1) {
      EXPECT_EQ(verdict, Verdict::unusable);  // below course_speed
      continue;
    }
    EXPECT_EQ(verdict, Verdict::accepted);
    EXPECT_NEAR(ekf.estimate().X_MB.theta, 0.55, 1e-3);  // equal variances meet half way
  }
}

}  // namespace
}  // namespace bw::localization
