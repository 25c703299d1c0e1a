// When a solve of a band ends before it has converged.
#include "components/local_planner/teb/band_solver.hpp"

#include <gtest/gtest.h>

namespace bw::teb {
namespace {

// 10 iterations are allowed, the rival has 5. After 4 of them at cost 9, six gains of 0.5 lead to 6, above
// it; six of 0.7 to 4.8, below. After 2 nothing is said yet.
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

TEST(SolveProgress, GoesOnWhileFourIterationsGain15Percent) {
  const SolveLimits limits{.max_iterations = 4, .overtime = 3};
  // 100 to 86 in four.
  EXPECT_EQ(iterations_of({100, 96, 92, 89, 86, 60, 40, 20}, limits), 4);
  // 100 to 80, 95 to 79 and 92 to 78, then no iterations are left.
  EXPECT_EQ(iterations_of({100, 95, 92, 85, 80, 79, 78, 77, 76}, limits), 7);
  // 100 to 80, 95 to 79, then 85 to 79 after a step that was rejected.
  EXPECT_EQ(iterations_of({100, 95, 85, 80.5, 80, 79, 79.5, 79.4, 79.3}, limits), 6);
  EXPECT_EQ(iterations_of({100, 50, 25, 12, 6, 3}, {.max_iterations = 4}), 4);  // no overtime
}

// At 60 it is above its rival when its own iterations are spent.
TEST(SolveProgress, ALostBandTakesNoOvertime) {
  const SolveLimits limits{.max_iterations = 4, .rival = 50.0, .overtime = 8};
  EXPECT_EQ(iterations_of({100, 95, 90, 70, 60, 55, 50, 45}, limits), 4);
}

}  // namespace
}  // namespace bw::teb
