// The assignment against trying everything, and against a second look at large problems.
#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "components/model/random.hpp"
#include "components/people/tracker/assignment.hpp"

namespace bw::people {
namespace {

struct Problem {
  std::size_t columns = 0;
  std::vector<double> alone;                              // per row
  std::vector<std::vector<std::optional<double>>> costs;  // nothing: not possible
};

Problem random_problem(Random& random, std::size_t rows, std::size_t columns, double share, bool whole) {
  Problem problem{columns, {}, {}};
  for (std::size_t i = 0; i < rows; ++i) {
    problem.alone.push_back(whole ? static_cast<double>(random.bits() % 8) : random.uniform(-2.0, 10.0));
    problem.costs.emplace_back(columns);
    for (auto& cost : problem.costs.back()) {
      if (random.uniform() >= share) continue;
      cost = whole ? static_cast<double>(random.bits() % 10) : random.uniform(-5.0, 12.0);
    }
  }
  return problem;
}

/// Every way there is, row by row.
double cheapest(const Problem& problem, std::size_t row, std::vector<bool>& taken) {
  if (row == problem.alone.size()) return 0.0;
  double best = problem.alone[row] + cheapest(problem, row + 1, taken);
  for (std::size_t j = 0; j < problem.columns; ++j) {
    if (taken[j] || !problem.costs[row][j]) continue;
    taken[j] = true;
    best = std::min(best, *problem.costs[row][j] + cheapest(problem, row + 1, taken));
    taken[j] = false;
  }
  return best;
}

const std::vector<int>& solve(Assignment& assignment, const Problem& problem) {
  assignment.begin(problem.columns);
  for (std::size_t i = 0; i < problem.alone.size(); ++i) {
    assignment.add_row(problem.alone[i]);
    for (std::size_t j = 0; j < problem.columns; ++j)
      if (problem.costs[i][j]) assignment.allow(j, *problem.costs[i][j]);
  }
  return assignment.solve();
}

/// Sum of what was chosen; fails when something impossible or a column twice was.
double price(const Problem& problem, const std::vector<int>& chosen) {
  std::vector<bool> taken(problem.columns, false);
  double sum = 0.0;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (chosen[i] == Assignment::kAlone) {
      sum += problem.alone[i];
      continue;
    }
    const auto j = static_cast<std::size_t>(chosen[i]);
    EXPECT_TRUE(problem.costs[i][j].has_value());
    EXPECT_FALSE(taken[j]);
    taken[j] = true;
    sum += problem.costs[i][j].value_or(0.0);
  }
  return sum;
}

// Up to 6 x 6, all shares of impossible pairs; whole numbers give many equal prices.
TEST(Assignment, CostsAsLittleAsTheBestOfAllWays) {
  Random random(1);
  Assignment assignment;
  for (int trial = 0; trial < 4000; ++trial) {
    const auto rows = static_cast<std::size_t>(random.bits() % 7);
    const auto columns = static_cast<std::size_t>(random.bits() % 7);
    const Problem problem = random_problem(random, rows, columns, random.uniform(0.1, 1.0), trial % 2 == 0);
    const std::vector<int>& chosen = solve(assignment, problem);
    ASSERT_EQ(chosen.size(), rows);
    std::vector<bool> taken(columns, false);
    const double best = cheapest(problem, 0, taken);
    EXPECT_NEAR(price(problem, chosen), best, 1e-9) << "trial " << trial;
    EXPECT_NEAR(assignment.total(), best, 1e-9) << "trial " << trial;
  }
}

// Adding a number to every cost of a row (and to its price alone) cannot change who gets what, and the total
// by exactly the sum of what was added. 150 x 150, everything possible.
TEST(Assignment, LargeProblemsKeepTheirSolutionWhenRowsAreShifted) {
  Random random(2);
  Assignment assignment;
  Problem problem = random_problem(random, 150, 150, 1.0, false);
  const std::vector<int> before = solve(assignment, problem);
  const double total = assignment.total();
  double added = 0.0;
  for (std::size_t i = 0; i < problem.alone.size(); ++i) {
    const double shift = random.uniform(-20.0, 20.0);
    added += shift;
    problem.alone[i] += shift;
    for (auto& cost : problem.costs[i]) *cost += shift;
  }
  EXPECT_EQ(solve(assignment, problem), before);
  EXPECT_NEAR(assignment.total(), total + added, 1e-6);
}

// Taking the nearest first would give the first row column 0 (1) and leave 9 for the second: 10 in all.
TEST(Assignment, IsNotGreedy) {
  Assignment assignment;
  assignment.begin(2);
  assignment.add_row(100.0);
  assignment.allow(0, 1.0);
  assignment.allow(1, 2.0);
  assignment.add_row(100.0);
  assignment.allow(0, 2.0);
  assignment.allow(1, 9.0);
  EXPECT_EQ(assignment.solve(), (std::vector<int>{1, 0}));
  EXPECT_DOUBLE_EQ(assignment.total(), 4.0);
}

TEST(Assignment, NothingToAssign) {
  Assignment assignment;
  assignment.begin(0);
  EXPECT_TRUE(assignment.solve().empty());
  assignment.begin(0);
  assignment.add_row(3.0);
  EXPECT_EQ(assignment.solve(), std::vector<int>{Assignment::kAlone});
  EXPECT_DOUBLE_EQ(assignment.total(), 3.0);
}

}  // namespace
}  // namespace bw::people
