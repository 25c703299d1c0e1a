// Comparisons, weights, drawing, and how many particles.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "components/localization/particle_filter/comparison.hpp"
#include "components/localization/particle_filter/pose_histogram.hpp"
#include "components/localization/particle_filter/weights.hpp"
#include "tests/components/localization/particle_filter_random_set.hpp"

namespace bw::localization {
namespace {

// Two particles 0 and 1 m, one reading 0.25 m with 0.5 m: w ~ exp(-0.125), exp(-1.125), so that w0 = 1 / (1 +
// exp(-1)).
TEST(Weights, GaussianInOneDimensionIsTheClosedForm) {
  ParticleSet set;
  set.resize(2);
  set.x[1] = 1.0;
  set.weight = {0.5, 0.5};
  PositionFix fix;
  fix.position = {0.25, 0.0};
  fix.covariance << 0.25, 0.0, 0.0, 4.0;
  const Comparison c = compare_at(fix, {}, false);
  Differences d;
  differences(c, set, d);
  std::vector<double> log_weight(2, 0.0);
  add_log_weights(c, d, WeightLaw::gaussian, log_weight);
  EXPECT_NEAR(log_weight[0], -0.125, 1e-12);
  EXPECT_NEAR(log_weight[1], -1.125, 1e-12);
  ASSERT_TRUE(reweigh(set.weight, log_weight));
  EXPECT_NEAR(set.weight[0], 1.0 / (1.0 + std::exp(-1.0)), 1e-6);

  // EN = 0.25 / 0.5 and 0.75 / 0.5 standard deviations; metres as they are without the division.
  std::vector<double> printed(2, 0.0);
  add_log_weights(c, d, WeightLaw::printed, printed);
  EXPECT_NEAR(printed[0], -0.5 * std::pow(0.5, 0.4), 1e-12);
  EXPECT_NEAR(printed[1], -0.5 * std::pow(1.5, 0.4), 1e-12);
  std::vector<double> unscaled(2, 0.0);
  add_log_weights(c, d, WeightLaw::printed_unscaled, unscaled);
  EXPECT_NEAR(unscaled[1], -0.5 * std::pow(0.75, 0.4), 1e-12);
}

// A correlated covariance: d^T R^-1 d worked out by Eigen, for all kinds.
TEST(Weights, EveryKindComparesWhatItReads) {
  const ParticleSet set = random_set(50, 3, 2.0);
  Random random(4);
  const Pose2 X_BS{-0.3, 0.1, -0.4};  // the base at the stamp, seen from now
  PositionFix fix;
  fix.position = {1.0, -2.0};
  fix.covariance << 0.3, 0.1, 0.1, 0.2;
  fix.antenna = {0.4, -0.2};
  PoseReading pose;
  pose.X_MB = {0.5, 0.7, 3.0};
  pose.covariance << 0.3, 0.1, 0.02, 0.1, 0.2, 0.03, 0.02, 0.03, 0.1;
  RangeReading range;
  range.range = 3.0;
  range.variance = 0.04;
  range.anchor = {4.0, 1.0};
  range.antenna = {0.1, 0.1};
  const HeadingReading heading{{}, 0, -3.0, 0.01};
  const CourseReading course{{}, 0, 2.0, 0.02};
  const auto check = [&](const Comparison& c, auto expected) {
    Differences d;
    differences(c, set, d);
    std::vector<double> log_weight(set.size(), 0.0);
    add_log_weights(c, d, WeightLaw::gaussian, log_weight);
    for (std::size_t i = 0; i < set.size(); ++i) {
      const Pose2 X_MS = Pose2{set.x[i], set.y[i], set.theta[i]} * X_BS;
      const double value = expected(X_MS);
      EXPECT_NEAR(log_weight[i], value, 1e-5 * (1.0 + std::abs(value))) << i;
    }
  };
  check(compare_at(fix, X_BS, false), [&](const Pose2& X_MS) {
    const Vector2 r = fix.position - X_MS * fix.antenna;
    return -0.5 * r.dot(fix.covariance.llt().solve(r));
  });
  check(compare_at(pose, X_BS, false), [&](const Pose2& X_MS) {
    const Eigen::Vector3d r(pose.X_MB.x - X_MS.x, pose.X_MB.y - X_MS.y,
                            wrap_angle(pose.X_MB.theta - X_MS.theta));
    return -0.5 * r.dot(pose.covariance.llt().solve(r));
  });
  check(compare_at(range, X_BS, false), [&](const Pose2& X_MS) {
    const double r = range.range - (range.anchor - X_MS * range.antenna).norm();
    return -0.5 * r * r / range.variance;
  });
  check(compare_at(heading, X_BS, false), [&](const Pose2& X_MS) {
    const double r = wrap_angle(heading.heading - X_MS.theta);
    return -0.5 * r * r / heading.variance;
  });
  check(compare_at(course, X_BS, true), [&](const Pose2& X_MS) {
    const double r = wrap_angle(course.course + std::numbers::pi - X_MS.theta);
    return -0.5 * r * r / course.variance;
  });
}

TEST(Weights, NothingFiniteKeepsThem) {
  const double inf = std::numeric_limits<double>::infinity();
  std::vector<double> w{0.5, 0.25, 0.25};
  EXPECT_FALSE(reweigh(w, std::vector<double>{-inf, -inf, -inf}));
  EXPECT_FALSE(reweigh(w, std::vector<double>{NAN, NAN, NAN}));
  EXPECT_FALSE(reweigh(w, std::vector<double>{inf, 0.0, 0.0}));
  EXPECT_EQ(w, (std::vector<double>{0.5, 0.25, 0.25}));
  // A likelihood far below anything a double holds is still compared, and NaN is none.
  ASSERT_TRUE(reweigh(w, std::vector<double>{-5000.0, -5001.0, NAN}));
  EXPECT_NEAR(w[0], 1.0 / (1.0 + 0.5 * std::exp(-1.0)), 1e-6);
  EXPECT_EQ(w[2], 0.0);
  EXPECT_NEAR(w[0] + w[1], 1.0, 1e-12);
}

TEST(Weights, EffectiveSize) {
  EXPECT_NEAR(effective_size(std::vector<double>(40, 1.0 / 40.0)), 40.0, 1e-9);
  EXPECT_NEAR(effective_size(std::vector<double>{1.0, 0.0, 0.0}), 1.0, 1e-12);
  EXPECT_NEAR(effective_size(std::vector<double>{0.5, 0.5, 0.0}), 2.0, 1e-12);
}

// Every draw has floor or ceil of N w copies; over u uniform (a fine grid) the mean is N w.
TEST(SystematicDraw, CountsAreUnbiased) {
  const ParticleSet set = random_set(37, 9, 1.0);
  constexpr std::size_t kDrawn = 100;
  constexpr int kOffsets = 2000;
  std::vector<double> mean(set.size(), 0.0);
  std::vector<std::size_t> which;
  for (int k = 0; k < kOffsets; ++k) {
    systematic_draw(set.weight, kDrawn, (k + 0.5) / kOffsets, which);
    std::vector<int> copies(set.size(), 0);
    for (const std::size_t i : which) ++copies[i];
    for (std::size_t i = 0; i < set.size(); ++i) {
      const double expected = kDrawn * set.weight[i];
      ASSERT_GE(copies[i], std::floor(expected - 1e-9));
      ASSERT_LE(copies[i], std::ceil(expected + 1e-9));
      mean[i] += static_cast<double>(copies[i]) / kOffsets;
    }
  }
  for (std::size_t i = 0; i < set.size(); ++i) EXPECT_NEAR(mean[i], kDrawn * set.weight[i], 1.0 / kOffsets);
}

TEST(SystematicDraw, NeverTakesAParticleWithoutWeight) {
  std::vector<double> weight{0.0, 0.3, 0.0, 0.7 - 1e-12, 0.0, 0.0};  // rounding leaves the sum below 1
  std::vector<std::size_t> which;
  for (const double u : {0.0, 0.5, 1.0 - 1e-16}) {
    systematic_draw(weight, 1000, u, which);
    for (const std::size_t i : which) ASSERT_TRUE(i == 1 || i == 3) << i;
  }
}

// Fox 2003: the quantile of chi-square over 2 error. Tables: chi^2 of 9 and 99 degrees at 0.99: 21.666,
// 134.642.
TEST(KldBound, IsTheChiSquareQuantile) {
  constexpr double kZ99 = 2.3263479;
  EXPECT_NEAR(kld_bound(10, 0.05, kZ99), 21.666 / 0.1, 0.5);
  EXPECT_NEAR(kld_bound(100, 0.05, kZ99), 134.642 / 0.1, 0.5);
  EXPECT_EQ(kld_bound(1, 0.05, kZ99), 0.0);
}

// Fox's rule draws one by one until the count reaches the bound of the bins hit so far; ours finds the same
// count without drawing.
TEST(KldCount, IsWhereDrawingOneByOneStops) {
  const ParticleSet set = random_set(4000, 11, 1.0);
  PoseHistogram histogram;
  histogram.fill(set);
  const std::size_t count = kld_count(histogram, 0.05, 0.99, 10, 50'000);
  Random random(12);
  std::vector<double> sums(set.size());
  std::partial_sum(set.weight.begin(), set.weight.end(), sums.begin());
  double mean = 0.0;
  constexpr int kRuns = 20;
  for (int run = 0; run < kRuns; ++run) {
    std::vector<bool> hit(histogram.bins(), false);
    double bins = 0.0;
    double drawn = 0.0;
    while (drawn < 10.0 || drawn < kld_bound(bins, 0.05, 0.99)) {
      const auto i = static_cast<std::size_t>(
          std::lower_bound(sums.begin(), sums.end() - 1, random.uniform()) - sums.begin());
      const std::uint32_t bin = histogram.bin_of()[i];
      if (!hit[bin]) bins += 1.0;
      hit[bin] = true;
      drawn += 1.0;
    }
    mean += drawn / kRuns;
  }
  EXPECT_NEAR(static_cast<double>(count) / mean, 1.0, 0.02);
}

TEST(KldCount, OneBinNeedsTheLeast) {
  ParticleSet set;
  set.resize(100);
  std::fill(set.weight.begin(), set.weight.end(), 0.01);
  PoseHistogram histogram;
  histogram.fill(set);
  EXPECT_EQ(histogram.bins(), 1U);
  EXPECT_EQ(kld_count(histogram, 0.05, 0.99, 30, 500), 30U);
}

}  // namespace
}  // namespace bw::localization
