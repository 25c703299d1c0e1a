#include "components/evaluation/thinning.hpp"

#include <gtest/gtest.h>

namespace bw {
namespace {

/// Looks at 100 Hz for `hours`, each the second it was made at.
std::vector<double> watched(double hours) {
  std::vector<double> history;
  Thinning thinning(Duration::milliseconds(100), 1000);
  for (int i = 0; i < static_cast<int>(hours * 3600.0) * 100; ++i) {
    const Time now = Time{} + Duration::milliseconds(10) * i;
    if (thinning.is_due(now)) thinning.add(now, 0.01 * i, history);
  }
  return history;
}

// Whatever is left over covers the whole time evenly.
TEST(Thinning, ADayTakesNoMoreThanAMinute) {
  for (const double hours : {0.1, 1.0, 3.0}) {
    const std::vector<double> history = watched(hours);
    EXPECT_LT(history.size(), 1000U);
    EXPECT_GE(history.size(), 499U);
    EXPECT_EQ(history.front(), 0.0);
    const double period = history[1] - history[0];
    for (std::size_t i = 1; i < history.size(); ++i) {
      EXPECT_GT(history[i] - history[i - 1], period - 1e-6);  // more where one was dropped
      EXPECT_LT(history[i] - history[i - 1], 2.0 * period);
    }
    EXPECT_GT(history.back() + 2.0 * period, hours * 3600.0);
  }
}

TEST(Thinning, BelowItsBoundItKeepsEachPeriod) { EXPECT_EQ(watched(1.0 / 3600.0).size(), 10U); }

}  // namespace
}  // namespace bw
