// Elementary functions, random numbers, histogram and moments of a set.
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <gtest/gtest.h>

#include "components/localization/particle_filter/lane_random.hpp"
#include "components/localization/particle_filter/pose_histogram.hpp"
#include "components/localization/particle_filter/set_estimate.hpp"
#include "components/localization/particle_filter/vector_math.hpp"
#include "tests/components/localization/particle_filter_random_set.hpp"

namespace bw::localization {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(VectorMath, AgreesWithTheLibrary) {
  Random random(1);
  for (int i = 0; i < 200'000; ++i) {
    const auto angle = static_cast<float>(random.uniform(-100.0, 100.0));
    const SinCos t = sin_cos(angle);
    ASSERT_NEAR(t.sin, std::sin(static_cast<double>(angle)), 3e-7) << angle;
    ASSERT_NEAR(t.cos, std::cos(static_cast<double>(angle)), 3e-7) << angle;
    const auto value = static_cast<float>(std::exp(random.uniform(-80.0, 80.0)));
    ASSERT_NEAR(fast_log(value), std::log(static_cast<double>(value)),
                1e-6 + 1e-7 * std::abs(std::log(value)));
    const auto exponent = static_cast<float>(random.uniform(-86.0, 0.0));
    const double exact = std::exp(static_cast<double>(exponent));
    ASSERT_NEAR(fast_exp(exponent), exact, 1e-6 * exact) << exponent;
    const double unwrapped = random.uniform(-1e6, 1e6);
    const double wrapped = fast_wrap(unwrapped);
    ASSERT_LE(std::abs(wrapped), kPi + 1e-9);
    ASSERT_NEAR(std::sin(wrapped - unwrapped), 0.0, 1e-9);
    ASSERT_NEAR(std::cos(wrapped - unwrapped), 1.0, 1e-9);
  }
  EXPECT_EQ(fast_exp(0.0F), 1.0F);
  EXPECT_EQ(fast_exp(-1e9F), 0.0F);
  EXPECT_EQ(fast_log(1.0F), 0.0F);
}

// Of a million standard normal draws: mean 0 +- 0.004, variance 1 +- 0.006, fourth moment 3 +- 0.04, beyond
// two 4.550 % +- 0.085 % (four standard errors each); and no correlation between neighbours or lanes.
TEST(LaneRandom, DrawsAreNormalAndIndependent) {
  LaneRandom random(5);
  std::vector<float> n;
  random.normals(n, 1'000'000);
  ASSERT_EQ(n.size(), 1'000'000U);
  double mean = 0.0, squares = 0.0, fourth = 0.0, beyond = 0.0;
  for (const float v : n) {
    const double x = v;
    mean += x * 1e-6;
    squares += x * x * 1e-6;
    fourth += x * x * x * x * 1e-6;
    beyond += (std::abs(x) > 2.0 ? 1e-6 : 0.0);
  }
  EXPECT_NEAR(mean, 0.0, 0.004);
  EXPECT_NEAR(squares, 1.0, 0.006);
  EXPECT_NEAR(fourth, 3.0, 0.04);
  EXPECT_NEAR(beyond, 0.0455, 0.00085);
  for (const std::size_t apart : {1U, 2U, 15U, 16U, 31U, 32U, 64U}) {
    double products = 0.0;
    double of_squares = 0.0;
    for (std::size_t i = 0; i + apart < n.size(); ++i) {
      const double a = n[i];
      const double b = n[i + apart];
      products += a * b * 1e-6;
      of_squares += (a * a - 1.0) * (b * b - 1.0) * 1e-6;
    }
    EXPECT_NEAR(products, 0.0, 0.004) << apart;
    EXPECT_NEAR(of_squares, 0.0, 0.009) << apart;
  }
}

TEST(LaneRandom, SameSeedSameDraws) {
  LaneRandom a(7), b(7), c(8);
  std::vector<float> x, y, z;
  a.normals(x, 100);
  b.normals(y, 100);
  c.normals(z, 100);
  EXPECT_EQ(x, y);
  EXPECT_NE(x, z);
  a.normals(y, 100);
  EXPECT_NE(x, y);
}

// Bins by an ordered map, weight by weight.
TEST(PoseHistogram, HoldsTheWeightOfEveryBin) {
  const ParticleSet set = random_set(3000, 21, 3.0);
  PoseHistogram histogram;
  histogram.fill(set);
  std::map<std::tuple<int, int, int>, double> expected;
  for (std::size_t i = 0; i < set.size(); ++i) {
    const auto heading = static_cast<int>((set.theta[i] + kPi) / (2.0 * kPi) * 36.0);
    expected[{static_cast<int>(std::floor(set.x[i] / 0.5)), static_cast<int>(std::floor(set.y[i] / 0.5)),
              heading}] += set.weight[i];
  }
  EXPECT_EQ(histogram.bins(), expected.size());
  std::vector<double> a(histogram.weights());
  std::vector<double> b;
  for (const auto& [bin, weight] : expected) b.push_back(weight);
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  for (std::size_t i = 0; i < b.size(); ++i) ASSERT_NEAR(a[i], b[i], 1e-12);
}

// Two heaps 5 m apart, the heavier one with headings on both sides of pi: one group, and its mean is the
// answer.
TEST(SetEstimate, IsThatOfTheHeaviestGroupAcrossTheWrap) {
  Random random(31);
  ParticleSet set;
  set.resize(1000);
  for (std::size_t i = 0; i < set.size(); ++i) {
    const bool heavy = i % 10 < 7;
    set.x[i] = (heavy ? 2.0 : 7.0) + 0.1 * random.normal();
    set.y[i] = 1.0 + 0.1 * random.normal();
    set.theta[i] = heavy ? wrap_angle(kPi + 0.1 * random.normal()) : 0.1 * random.normal();
    set.weight[i] = 1e-3;
  }
  PoseHistogram histogram;
  const SetEstimate e = estimate_of_heaviest(set, histogram);
  EXPECT_NEAR(e.share, 0.7, 1e-9);
  EXPECT_NEAR(e.X_MB.x, 2.0, 0.015);  // 4 standard errors of 700 draws
  EXPECT_NEAR(std::abs(e.X_MB.theta), kPi, 0.015);
  EXPECT_NEAR(e.covariance(0, 0), 0.01, 0.0022);
  EXPECT_NEAR(e.covariance(2, 2), 0.01, 0.0022);
  const SetEstimate all = estimate_of(set);
  EXPECT_NEAR(all.X_MB.x, 3.5, 0.015);
}

TEST(SetEstimate, MomentsAreTheDefinitions) {
  const ParticleSet set = random_set(777, 41, 5.0);
  const SetEstimate e = estimate_of(set);
  double x = 0.0, y = 0.0, s = 0.0, c = 0.0;
  for (std::size_t i = 0; i < set.size(); ++i) {
    x += set.weight[i] * set.x[i];
    y += set.weight[i] * set.y[i];
    s += set.weight[i] * std::sin(set.theta[i]);
    c += set.weight[i] * std::cos(set.theta[i]);
  }
  EXPECT_NEAR(e.X_MB.x, x, 1e-9);
  EXPECT_NEAR(e.X_MB.y, y, 1e-9);
  EXPECT_NEAR(e.X_MB.theta, std::atan2(s, c), 1e-5);
  Eigen::Matrix3d C = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < set.size(); ++i) {
    const Eigen::Vector3d d(set.x[i] - x, set.y[i] - y, wrap_angle(set.theta[i] - e.X_MB.theta));
    C += set.weight[i] * d * d.transpose();
  }
  EXPECT_LT((e.covariance - C).cwiseAbs().maxCoeff(), 1e-8);
}

}  // namespace
}  // namespace bw::localization
