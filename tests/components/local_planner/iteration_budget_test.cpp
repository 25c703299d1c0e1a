#include "components/local_planner/iteration_budget.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "components/model/random.hpp"

namespace bw {
namespace {

TEST(IterationBudget, GivesAllUntilItKnows) {
  IterationBudget budget(0.05, 100);
  EXPECT_EQ(budget.iterations(), 100);
  budget.observe(0, 0.02);
  budget.observe(20, 0.0);
  budget.observe(20, std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(budget.iterations(), 100);  // none of these says how long one takes
}

// 50 ms at 2 ms each: 25. At 0.1 ms each 500, and at 20 ms each 2.5, would fit: the two ends hold.
TEST(IterationBudget, DividesTheTimeByWhatOneTakes) {
  const auto after = [](double ms_each, int max_iterations) {
    IterationBudget budget(0.05 + 1e-9, max_iterations);
    budget.observe(20, 20 * ms_each * 1e-3);
    return budget.iterations();
  };
  EXPECT_EQ(after(2.0, 100), 25);
  EXPECT_EQ(after(0.1, 100), 100);
  EXPECT_EQ(after(20.0, 100), IterationBudget::kMinIterations);
  EXPECT_EQ(after(20.0, 4), 4);
}

// One cycle that was held up ten times as long moves the mean time by a tenth of the difference: 40 ms become
// 76 ms for 20 iterations, so that 13 fit into 50 ms where 25 did; twenty usual cycles later it is forgotten
// but for 0.9^20 = 12 % of the excess: 44.4 ms, 22.
TEST(IterationBudget, ForgetsASlowCycle) {
  IterationBudget budget(0.05 + 1e-9, 100);
  for (int i = 0; i < 10; ++i) budget.observe(20, 0.04);
  EXPECT_EQ(budget.iterations(), 25);
  budget.observe(20, 0.4);
  EXPECT_EQ(budget.iterations(), 13);
  for (int i = 0; i < 20; ++i) budget.observe(20, 0.04);
  EXPECT_EQ(budget.iterations(), 22);
}

// A planner that takes 5 ms plus 0.5 ms for each iteration and always uses its budget settles where the cycle
// takes the time allowed: 20 ms, 30 iterations. From 100 iterations it comes down, from few it comes up.
TEST(IterationBudget, SettlesWhereTheCycleTakesItsTime) {
  for (const double first_ms : {1.0, 55.0, 400.0}) {
    IterationBudget budget(0.02, 100);
    budget.observe(20, first_ms * 1e-3);
    for (int cycle = 0; cycle < 300; ++cycle) {
      const int spent = budget.iterations();
      budget.observe(spent, (5.0 + 0.5 * spent) * 1e-3);
    }
    EXPECT_NEAR(budget.iterations(), 30, 1) << first_ms;
  }
}

TEST(IterationBudget, StaysBetweenItsEndsWhateverItSees) {
  Random random(5);
  for (int run = 0; run < 1000; ++run) {
    const int max_iterations = 1 + static_cast<int>(random.uniform(0.0, 300.0));
    IterationBudget budget(std::pow(10.0, random.uniform(-6.0, 2.0)), max_iterations);
    for (int cycle = 0; cycle < 20; ++cycle) {
      budget.observe(static_cast<int>(random.uniform(-5.0, 500.0)),
                     std::pow(10.0, random.uniform(-12.0, 6.0)));
      ASSERT_GE(budget.iterations(), std::min(IterationBudget::kMinIterations, max_iterations));
      ASSERT_LE(budget.iterations(), max_iterations);
    }
  }
}

}  // namespace
}  // namespace bw
