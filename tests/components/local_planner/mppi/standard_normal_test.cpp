#include "components/local_planner/mppi/standard_normal.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace bw::mppi {
namespace {

// Moments 0, 1, 0, 3; shares beyond z are erfc(z / sqrt 2). Bounds are five standard errors of a million
// draws: sqrt(var / n), var of x, x^2, x^3, x^4 are 1, 2, 15, 96. Beyond 3.6541528853610088 begins the tail,
// which is drawn otherwise.
TEST(StandardNormal, HasTheMomentsAndTailsOfTheBell) {
  constexpr int kDraws = 1'000'000;
  StandardNormal normal(7);
  double sums[4] = {};
  constexpr double kBeyond[] = {0.5, 1.0, 2.0, 3.0, 3.6541528853610088, 4.0};
  int beyond[6] = {}, negative = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double x = normal.draw();
    double power = 1.0;
    for (double& sum : sums) sum += power *= x;
    for (int k = 0; k < 6; ++k) beyond[k] += std::abs(x) > kBeyond[k];
    negative += x < 0.0;
  }
  constexpr double kMoments[] = {0.0, 1.0, 0.0, 3.0};
  constexpr double kVariances[] = {1.0, 2.0, 15.0, 96.0};
  for (int k = 0; k < 4; ++k)
    EXPECT_NEAR(sums[k] / kDraws, kMoments[k], 5.0 * std::sqrt(kVariances[k] / kDraws)) << k + 1;
  for (int k = 0; k < 6; ++k) {
    const double share = std::erfc(kBeyond[k] / std::sqrt(2.0));
    EXPECT_NEAR(beyond[k], kDraws * share, 5.0 * std::sqrt(kDraws * share * (1.0 - share))) << kBeyond[k];
  }
  EXPECT_NEAR(negative, kDraws / 2, 5.0 * std::sqrt(kDraws / 4.0));
}

// Kolmogorov's statistic of 100,000 draws against the bell: above 1.95 / sqrt(n) once in a thousand seeds.
TEST(StandardNormal, IsDistributedAsTheBell) {
  constexpr int kDraws = 100'000;
  StandardNormal normal(8);
  std::vector<double> draws;
  for (int i = 0; i < kDraws; ++i) draws.push_back(normal.draw());
  std::sort(draws.begin(), draws.end());
  double largest = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double share = 0.5 * std::erfc(-draws[static_cast<std::size_t>(i)] / std::sqrt(2.0));
    largest = std::max(largest, std::abs(share - (i + 0.5) / kDraws));
  }
  EXPECT_LT(largest, 1.95 / std::sqrt(kDraws));
}

TEST(StandardNormal, IsTheSameForTheSameSeed) {
  StandardNormal one(3), same(3), other(4);
  int equal = 0;
  for (int i = 0; i < 1000; ++i) {
    const double x = one.draw();
    EXPECT_EQ(x, same.draw());
    equal += x == other.draw();
  }
  EXPECT_EQ(equal, 0);
}

}  // namespace
}  // namespace bw::mppi
