// When a solve of a band ends before it has converged.
#include "components/local_planner/teb/band_solver.hpp"

#include <gtest/gtest.h>

namespace bw::teb {
namespace {

// 10 iterations are allowed, the rival has 5. After 4 of them at cost 9, six gains of 0.5 lead to 6, above it; six of 0.7
// to 4.8, below. After 2 nothing is said yet.
TEST(SolveLimits, ABandIsLostWhenItsGainsDoNotLeadBelowItsRival) {
  const SolveLimits limits{10, 0.0, 5.0};
  EXPECT_TRUE(limits.is_lost(9.0, 0.5, 4));
  EXPECT_FALSE(limits.is_lost(9.0, 0.7, 4));
  EXPECT_FALSE(limits.is_lost(9.0, 0.0, 2));
  EXPECT_FALSE((SolveLimits{10, 0.0}).is_lost(9.0, 0.0, 9));  // it has none
}

// Costs after each iteration; the number of iterations that the solve takes.
int iterations_of(const std::vector<double>& costs, const SolveLimits& limits) {
  SolveProgress progress(limits, costs.front());
  for (std::size_t i = 1; i < costs.size(); ++i) {
    if (progress.ends(costs[i], costs[i - 1] - costs[i])) return static_cast<int>(i);
  }
  return -1;
}

TEST(SolveProgress, GoesOnWhileSixIterationsGainAQuarter) {
  const SolveLimits limits{.max_iterations = 6, .overtime = 3};
  // 100 to 78 in six: less than a quarter.
  EXPECT_EQ(iterations_of({100, 90, 85, 82, 80, 79, 78, 60, 40, 20}, limits), 6);
  // 40 %, then 90 to 59 and 80 to 58, then no iterations are left.
  EXPECT_EQ(iterations_of({100, 90, 80, 75, 70, 66, 60, 59, 58, 57, 56}, limits), 9);
  // 38 %, then 90 to 61, then 70 to 61 after a step that was rejected.
  EXPECT_EQ(iterations_of({100, 90, 70, 68, 66, 64, 62, 61, 61.5, 61.4}, limits), 8);
  EXPECT_EQ(iterations_of({100, 50, 25, 12, 6, 3, 2, 1}, {.max_iterations = 6}), 6);  // no overtime
}

// At 51 it is above its rival when its own iterations are spent.
TEST(SolveProgress, ALostBandTakesNoOvertime) {
  const SolveLimits limits{.max_iterations = 6, .rival = 50.0, .overtime = 8};
  EXPECT_EQ(iterations_of({100, 88, 76, 66, 60, 55, 51, 40, 30}, limits), 6);
}

}  // namespace
}  // namespace bw::teb
