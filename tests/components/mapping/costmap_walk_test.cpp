#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "components/mapping/costmap/cell_walk.hpp"
#include "components/model/random.hpp"

namespace bw {
namespace {

struct Step {
  int column, row;
  double leave;
};

std::vector<Step> walk(const Vector2& a, const Vector2& b) {
  std::vector<Step> steps;
  walk_cells(a, b, [&](int column, int row, double leave) {
    steps.push_back({column, row, leave});
    return true;
  });
  return steps;
}

// Independent: points a ten-thousandth of a cell apart on 500 random lines. Each lies in a visited cell, and
// in each visited cell lies one, unless less than two steps of the line are in it.
TEST(CellWalk, VisitsTheCellsOfAFineSampling) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Vector2 a{random.uniform(-20, 20), random.uniform(-20, 20)};
    const Vector2 b = a + random.uniform(0.0, 12.0) * direction(random.uniform(-4.0, 4.0));
    std::set<std::pair<int, int>> sampled;
    const int samples = 2 + static_cast<int>((b - a).norm() * 1e4);
    for (int i = 0; i <= samples; ++i) {
      const Vector2 p = a + (b - a) * (static_cast<double>(i) / samples);
      sampled.insert({static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y()))});
    }
    double enter = 0.0;
    for (const Step& step : walk(a, b)) {
      ASSERT_GE(step.leave, enter - 1e-12);
      if ((step.leave - enter) * samples > 2.0) {
        EXPECT_EQ(sampled.count({step.column, step.row}), 1u) << step.column << " " << step.row;
      }
      sampled.erase({step.column, step.row});
      enter = step.leave;
    }
    EXPECT_EQ(enter, 1.0);
    EXPECT_TRUE(sampled.empty());
  }
}

// From (0.5, 0.5) to (3.5, 0.5): cells 0 to 3 of the first row, left at (1, 2, 3 - 0.5) / 3 and at the end.
TEST(CellWalk, TellsWhereCellsAreLeft) {
  for (const bool back : {false, true}) {
    const Vector2 a{back ? 3.5 : 0.5, 0.5};
    const Vector2 b{back ? 0.5 : 3.5, 0.5};
    const std::vector<Step> steps = walk(a, b);
    ASSERT_EQ(steps.size(), 4u);
    for (int i = 0; i < 4; ++i) {
      EXPECT_EQ(steps[static_cast<std::size_t>(i)].column, back ? 3 - i : i);
      EXPECT_EQ(steps[static_cast<std::size_t>(i)].row, 0);
      EXPECT_DOUBLE_EQ(steps[static_cast<std::size_t>(i)].leave, i < 3 ? (i + 0.5) / 3.0 : 1.0);
    }
  }
}

TEST(CellWalk, TakesAPointAndEndsWhenTold) {
  ASSERT_EQ(walk({2.5, -1.5}, {2.5, -1.5}).size(), 1u);
  EXPECT_EQ(walk({2.5, -1.5}, {2.5, -1.5})[0].row, -2);
  int visits = 0;
  walk_cells({0.5, 0.5}, {100.5, 40.5}, [&](int, int, double) { return ++visits < 7; });
  EXPECT_EQ(visits, 7);
}

// Through the corner (1, 1): the cell beside it in x too, so that the walk stays connected.
TEST(CellWalk, StaysConnectedThroughCorners) {
  const std::vector<Step> steps = walk({0.5, 0.5}, {1.5, 1.5});
  ASSERT_EQ(steps.size(), 3u);
  EXPECT_EQ(steps[1].column, 1);
  EXPECT_EQ(steps[1].row, 0);
}

}  // namespace
}  // namespace bw
