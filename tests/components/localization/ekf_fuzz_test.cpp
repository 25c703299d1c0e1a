// Garbage in: the state stays finite and its covariance positive definite.
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "components/localization/ekf/ekf.hpp"
#include "tests/components/localization/simulated_drive.hpp"

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
  switch (random.bits() % 7) {
    case 0:
      return GyroReading{time, 0, odd_number(random, 1.0), odd_variance(random)};
    case 1: {
      WheelStep m;
      m.time = time;
      m.source = 1;
      m.over =
          Duration{static_cast<std::int64_t>(odd_number(random, 1.0) > -0.5 ? 1e9 * random.uniform() : -1e9)};
      m.separation = random.bits() % 2 == 0 ? 0.0 : odd_number(random, 0.4);
      m.distance = odd_number(random, 0.3);
      m.rotation = odd_number(random, 0.3);
      m.covariance = odd_covariance<2>(random);
      m.rounding = random.bits() % 2 == 0 ? 0.0 : odd_variance(random);
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
    case 5:
      return CourseReading{time, 5, odd_number(random, 2.0), odd_variance(random)};
    default: {
      RangeReading m{time, 6, std::abs(odd_number(random, 10.0)), odd_variance(random), {}, {}};
      m.anchor = {odd_number(random, 10.0), odd_number(random, 10.0)};
      m.antenna = {odd_number(random, 0.5), odd_number(random, 0.5)};
      return m;
    }
  }
}

void expect_sound(const Ekf& ekf, long i) {
  const EkfState& s = ekf.state();
  ASSERT_TRUE(s.x.allFinite()) << i;
  ASSERT_TRUE(s.P.allFinite()) << i << "\n" << s.P;
  ASSERT_EQ((s.P - s.P.transpose()).cwiseAbs().maxCoeff(), 0.0) << i;
  // Over their standard deviations: no positive definite matrix fails for its scales alone. An unused state
  // has none.
  const Eigen::Array<double, kStates, 1> variances = s.P.diagonal().array();
  const StateVector sigma = (variances > 0.0).select(variances.sqrt(), 1.0);
  StateMatrix C = s.P.array() / (sigma * sigma.transpose()).array();
  for (int k = 0; k < kStates; ++k) {
    if (variances(k) == 0.0) {
      ASSERT_EQ(C.col(k).cwiseAbs().maxCoeff(), 0.0) << i << "\n" << s.P;
      C(k, k) = 1.0;
    }
  }
  ASSERT_EQ(C.llt().info(), Eigen::Success) << i << "\n" << s.P;
  if (i % 100 == 0) {  // the least eigenvalue: bounded condition
    ASSERT_GT(Eigen::SelfAdjointEigenSolver<StateMatrix>(C).eigenvalues()(0), 1e-10) << i << "\n" << s.P;
  }
  ASSERT_LE(std::abs(s.x(2)), 3.14159265358979324) << i;
}

long from_environment(const char* name, long otherwise) {
  const char* value = std::getenv(name);
  return value != nullptr ? std::atol(value) : otherwise;
}

struct FuzzCase {
  const char* name;
  bool gated;
  bool adaptive;
};

class EkfFuzz : public ::testing::TestWithParam<FuzzCase> {};

// BANDWAGON_FUZZ_STEPS=10000000 runs the ten million of localization/evidence.md 9.3, BANDWAGON_FUZZ_SEED
// others.
TEST_P(EkfFuzz, AnyNumbersLeaveTheStateFiniteAndPositiveDefinite) {
  const long steps = from_environment("BANDWAGON_FUZZ_STEPS", 300'000);
  EkfOptions options;
  options.gate.enabled = GetParam().gated;
  options.adaptive.enabled = GetParam().adaptive;
  options.bias.heading_offset = true;
  Ekf ekf(options);
  Random random(static_cast<std::uint64_t>(from_environment("BANDWAGON_FUZZ_SEED", 1)));
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

INSTANTIATE_TEST_SUITE_P(Modes, EkfFuzz,
                         ::testing::Values(FuzzCase{"Gated", true, false}, FuzzCase{"Open", false, false},
                                           FuzzCase{"Adaptive", true, true}),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace bw::localization
