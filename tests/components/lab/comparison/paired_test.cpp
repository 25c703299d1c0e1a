#include "components/lab/comparison/paired.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "components/lab/comparison/rate_interval.hpp"

namespace bw {
namespace {

// Binomial sums by hand: 2 (1 + 7) / 2^7; 2 / 2^5; 2 (1 + 12 + 66) / 2^12; both sides of an even count are
// more than all.
TEST(McNemar, IsTheTwoSidedBinomial) {
  EXPECT_NEAR(mcnemar_p(1, 6), 0.125, 1e-12);
  EXPECT_NEAR(mcnemar_p(6, 1), 0.125, 1e-12);
  EXPECT_NEAR(mcnemar_p(5, 0), 0.0625, 1e-12);
  EXPECT_NEAR(mcnemar_p(2, 10), 158.0 / 4096.0, 1e-12);
  EXPECT_EQ(mcnemar_p(3, 3), 1.0);
  EXPECT_EQ(mcnemar_p(0, 0), 1.0);
  EXPECT_EQ(mcnemar_p(2000, 2000), 1.0);
  // Of many that of a normal with a step of one half: erfc((100 - 1) / sqrt(2 2000)) = 0.0269, to a hundredth
  // of it.
  EXPECT_NEAR(mcnemar_p(950, 1050), std::erfc(99.0 / std::sqrt(2.0 * 2000.0)), 3e-4);
}

TEST(Wilson, OfTwoOfFour) {
  EXPECT_NEAR(wilson95(2, 4).low, 0.1500, 5e-5);
  EXPECT_NEAR(wilson95(2, 4).high, 0.8500, 5e-5);
  EXPECT_EQ(wilson95(0, 0).high, 1.0);
}

TEST(BootstrapMean, OfEqualValuesHasNoWidth) {
  const MeanInterval interval = bootstrap_mean({0.25, 0.25, 0.25});
  EXPECT_EQ(interval.count, 3);
  EXPECT_EQ(interval.mean, 0.25);
  EXPECT_EQ(interval.low, 0.25);
  EXPECT_EQ(interval.high, 0.25);
}

// Of 200 zeros and 200 ones a resampled mean is Bin(400, 1/2) / 400: 0.5 -+ 1.96 0.025. A percentile of
// 10,000 samples is off by sqrt(0.025 0.975 / 10000) / (density 2.34 there) = 0.0007 of a standard normal's
// 1; steps are 1/400.
TEST(BootstrapMean, HasTheWidthOfTheBinomial) {
  std::vector<double> values(200, 0.0);
  values.resize(400, 1.0);
  const MeanInterval interval = bootstrap_mean(values);
  EXPECT_NEAR(interval.low, 0.5 - 1.96 * 0.025, 0.004);
  EXPECT_NEAR(interval.high, 0.5 + 1.96 * 0.025, 0.004);
  const MeanInterval again = bootstrap_mean(values);
  EXPECT_EQ(again.low, interval.low);
  EXPECT_EQ(again.high, interval.high);
}

TEST(BootstrapMean, LeavesOutWhatIsNotFinite) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(bootstrap_mean({1.0, none, 3.0, std::numeric_limits<double>::infinity()}).mean, 2.0);
  EXPECT_EQ(bootstrap_mean({1.0, none, 3.0}).count, 2);
  EXPECT_TRUE(std::isnan(bootstrap_mean({}).mean));
}

PairedEpisode episode(const std::string& key, bool success, double figure) {
  return {key, success, true, figure, 2.0 * figure, 3.0 * figure, 4.0 * figure};
}

// Pairs by key, whatever the order; who is in one list alone is no pair. Figures are of the one pair in which
// both succeeded.
TEST(Compare, PairsEpisodesByKey) {
  const std::vector<PairedEpisode> first = {episode("a", true, 1.0), episode("b", true, 1.0),
                                            episode("c", false, 1.0), episode("d", false, 1.0),
                                            episode("alone", true, 9.0)};
  const std::vector<PairedEpisode> second = {episode("d", false, 5.0), episode("c", true, 5.0),
                                             episode("b", false, 5.0), episode("a", true, 1.5),
                                             episode("other", true, 9.0)};
  const Comparison c = compare(first, second);
  EXPECT_EQ(c.pairs, 4);
  EXPECT_EQ(c.only_first, 1);
  EXPECT_EQ(c.only_second, 1);
  EXPECT_EQ(c.p, 1.0);
  EXPECT_EQ(c.success.mean, 0.0);
  EXPECT_EQ(c.success.count, 4);
  EXPECT_EQ(c.both, 1);
  EXPECT_EQ(c.collision_index.mean, 0.5);
  EXPECT_EQ(c.closest.mean, 1.0);
  EXPECT_EQ(c.jerk.mean, 1.5);
  EXPECT_EQ(c.time.mean, 2.0);
}

}  // namespace
}  // namespace bw
