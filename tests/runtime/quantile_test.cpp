#include "runtime/base/quantile.hpp"

#include <gtest/gtest.h>

namespace bw {
namespace {

// Of five samples the smallest with at least half of them at or below it is the third.
TEST(Quantile, IsTheNearestRank) {
  EXPECT_EQ(quantile({5, 1, 4, 2, 3}, 0.5), 3.0);
  EXPECT_EQ(quantile({5, 1, 4, 2, 3}, 0.99), 5.0);
  EXPECT_EQ(quantile({5, 1, 4, 2, 3}, 0.0), 1.0);
  EXPECT_EQ(quantile({4, 1, 3, 2}, 0.5), 2.0);
  EXPECT_EQ(quantile({}, 0.5), 0.0);
}

}  // namespace
}  // namespace bw
