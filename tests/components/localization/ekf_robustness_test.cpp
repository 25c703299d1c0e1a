// Garbage in: the state stays finite and its covariance positive definite. Steady state takes no memory.
#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>

#include <Eigen/Cholesky>
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

double odd_number(Random& random, double usual) {
  switch (random.bits() % 40) {
    case 0:
      return std::numeric_limits<double>::quiet_NaN();
    case 1:
      return random.uniform() < 0.5 ? std::numeric_limits<double>::infinity()
                                    : -std::numeric_limits<double>::infinity();
    case 2:
      return 0.0;
    case 3:
      return random.uniform(-1, 1) * 1e308;
    case 4:
      return random.uniform(-1, 1) * 1e-308;
    case 5:
      return random.uniform(-1, 1) * 1e6;
    default:
      return usual * random.normal();
  }
}

double odd_variance(Random& random) {
  return random.bits() % 8 == 0 ? odd_number(random, 1.0) : std::pow(10.0, random.uniform(-14.0, 6.5));
}

template <int N>
Eigen::Matrix<double, N, N> odd_covariance(Random& random) {
  Eigen::Matrix<double, N, N> C;
  for (int r = 0; r < N; ++r)
    for (int c = 0; c <= r; ++c) C(r, c) = C(c, r) = r == c ? odd_variance(random) : 0.0;
  if (random.bits() % 4 == 0)
    C(0, 1) = C(1, 0) = odd_number(random, 1.0) * std::sqrt(std::abs(C(0, 0) * C(1, 1)));
  if (random.bits() % 20 == 0) C(1, 0) = odd_number(random, 1.0);
  return C;
}

Measurement odd_measurement(Random& random, Time time) {
  switch (random.bits() % 6) {
    case 0:
      return GyroReading{time, 0, odd_number(random, 1.0), odd_variance(random)};
    case 1: {
      WheelStep m;
      m.time = time;
      m.source = 1;
      m.over =
          Duration{static_cast<std::int64_t>(odd_number(random, 1.0) > -0.5 ? 1e9 * random.uniform() : -1e9)};
      m.distance = odd_number(random, 0.3);
      m.turn = odd_number(random, 0.3);
      m.covariance = odd_covariance<2>(random);
      return m;
    }
    case 2: {
      PoseReading m;
      m.time = time;
      m.source = 2;
      m.X_MB = {odd_number(random, 10.0), odd_number(random, 10.0), odd_number(random, 2.0)};
      m.covariance = odd_covariance<3>(random);
      return m;
    }
    case 3: {
      PositionFix m;
      m.time = time;
      m.source = 3;
      m.position = {odd_number(random, 10.0), odd_number(random, 10.0)};
      m.antenna = {odd_number(random, 0.5), odd_number(random, 0.5)};
      m.covariance = odd_covariance<2>(random);
      return m;
    }
    case 4:
      return HeadingReading{time, 4, odd_number(random, 2.0), odd_variance(random)};
    default:
      return CourseReading{time, 5, odd_number(random, 2.0), odd_variance(random)};
  }
}

void expect_sound(const Ekf& ekf, long i) {
  const EkfState& s = ekf.state();
  ASSERT_TRUE(s.x.allFinite()) << i;
  ASSERT_TRUE(s.P.allFinite()) << i << "\n" << s.P;
  ASSERT_EQ((s.P - s.P.transpose()).cwiseAbs().maxCoeff(), 0.0) << i;
  const Eigen::Matrix3d P = s.P.topLeftCorner<3, 3>();
  ASSERT_EQ(P.llt().info(), Eigen::Success) << i << "\n" << P;
  ASSERT_LE(std::abs(s.x(2)), 3.14159265358979324) << i;
}

// BANDWAGON_FUZZ_STEPS=10000000 runs the ten million of anchors 1.6.
TEST(EkfRobustness, AnyNumbersLeaveTheStateFiniteAndPositiveDefinite) {
  const char* wanted = std::getenv("BANDWAGON_FUZZ_STEPS");
  const long steps = wanted != nullptr ? std::atol(wanted) : 300'000;
  for (const bool gated : {true, false}) {
    EkfOptions options;
    options.gate.enabled = gated;
    options.bias.heading_offset = true;
    Ekf ekf(options);
    Random random(gated ? 1 : 2);
    Time now = kStart;
    long used_ones = 0;
    for (long i = 0; i < steps; ++i) {
      now = now + Duration::seconds(random.bits() % 1000 == 0 ? random.uniform(0.0, 100.0)
                                                              : random.uniform(0.0, 0.02));
      if (random.bits() % 100000 == 0) now = now - Duration::seconds(random.uniform(0.0, 1000.0));
      Time time = now;
      if (random.bits() % 4 == 0) time = time - Duration::seconds(random.uniform(0.0, 0.1));
      if (random.bits() % 300 == 0) time = Time{static_cast<std::int64_t>(random.bits()) / 4};
      used_ones += used(ekf.add(odd_measurement(random, time), now).verdict) ? 1 : 0;
      if (ekf.initialised()) expect_sound(ekf, i);
      if (::testing::Test::HasFatalFailure()) return;
    }
    EXPECT_TRUE(ekf.initialised());
    EXPECT_GT(used_ones, steps / 20);
  }
}

// A thousand crossings of +-pi, half of them turning on the spot: no step of the heading beyond three
// standard deviations of its own (anchors 1.6).
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
    step.turn += 1e-3 * random.normal();
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
