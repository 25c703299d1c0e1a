#include "components/model/chi_square.hpp"

#include <gtest/gtest.h>

namespace bw {
namespace {

// Printed tables of the chi-square distribution.
TEST(ChiSquare, QuantilesMatchPrintedTables) {
  EXPECT_NEAR(chi_square_quantile(0.999, 1), 10.828, 5e-4);
  EXPECT_NEAR(chi_square_quantile(0.999, 2), 13.816, 5e-4);
  EXPECT_NEAR(chi_square_quantile(0.999, 3), 16.266, 5e-4);
  EXPECT_NEAR(chi_square_quantile(0.95, 1), 3.841, 5e-4);
  EXPECT_NEAR(chi_square_quantile(0.95, 2), 5.991, 5e-4);
  EXPECT_NEAR(chi_square_quantile(0.95, 3), 7.815, 5e-4);
  EXPECT_NEAR(chi_square_quantile(0.025, 3), 0.216, 5e-4);
}

TEST(ChiSquare, IsZeroForNothingAndNan) {
  EXPECT_EQ(chi_square_cdf(0.0, 2), 0.0);
  EXPECT_EQ(chi_square_cdf(-1.0, 1), 0.0);
  EXPECT_EQ(chi_square_cdf(std::nan(""), 3), 0.0);
}

}  // namespace
}  // namespace bw
