#include "components/local_planner/dwa/sample_score.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "components/model/random.hpp"

namespace bw::dwa {
namespace {

using ::testing::ElementsAre;

TEST(Normalised, ByScaleSumAndRange) {
  EXPECT_THAT(normalised({1.0, 2.0, 5.0}, Normalisation::scale, 4.0), ElementsAre(0.25, 0.5, 1.25));
  EXPECT_THAT(normalised({1.0, 2.0, 5.0}, Normalisation::sum, 4.0), ElementsAre(0.125, 0.25, 0.625));
  EXPECT_THAT(normalised({1.0, 2.0, 5.0}, Normalisation::minmax, 4.0), ElementsAre(0.0, 0.25, 1.0));
}

TEST(Normalised, ColumnsThatSayNothingBecomeZero) {
  EXPECT_THAT(normalised({0.0, 0.0}, Normalisation::sum, 1.0), ElementsAre(0.0, 0.0));
  EXPECT_THAT(normalised({2.0, 2.0}, Normalisation::minmax, 1.0), ElementsAre(0.0, 0.0));
  EXPECT_TRUE(normalised({}, Normalisation::minmax, 1.0).empty());
}

TEST(Normalised, SumsToOneOrSpansZeroToOne) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    std::vector<double> column(1 + random.bits() % 300);
    for (double& value : column) value = random.uniform(0.0, 5.0);
    const std::vector<double> shares = normalised(column, Normalisation::sum, 1.0);
    EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1.0, 1e-12);
    if (column.size() < 2) continue;
    const std::vector<double> spanned = normalised(column, Normalisation::minmax, 1.0);
    EXPECT_EQ(*std::min_element(spanned.begin(), spanned.end()), 0.0);
    EXPECT_EQ(*std::max_element(spanned.begin(), spanned.end()), 1.0);
  }
}

TEST(Objective, IsTheWeightedSumOfTheColumns) {
  // 3 * 1/2 + 0.1 * 1.5/3 + 0.1 * 0.8/1 = 1.63 by fixed scales.
  const std::vector<double> scores =
      objective({{std::numbers::pi / 2.0}, {1.5}, {0.8}}, {3.0, 0.1, 0.1}, Normalisation::scale, {3.0, 1.0});
  EXPECT_NEAR(scores.at(0), 1.63, 1e-12);
}

}  // namespace
}  // namespace bw::dwa
