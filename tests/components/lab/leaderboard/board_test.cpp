#include "components/lab/leaderboard/board.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace bw {
namespace {

BoardDrive drive(int number, int start, bool success, double time = 10.0) {
  BoardDrive one;
  one.key = std::to_string(number);
  one.start = std::to_string(start);
  one.success = success;
  one.time = time;
  return one;
}

// 400 drives, of which 300 succeed. Each its own start: about the normal interval, 0.75 +- 1.96 sqrt(0.75 0.25 / 400) =
// 0.042. In 40 starts of ten alike: the same with n = 40, +- 0.134, in steps of 1 / 40.
TEST(Board, IntervalsAreOverStarts) {
  std::vector<BoardDrive> apart, together;
  for (int k = 0; k < 400; ++k) {
    apart.push_back(drive(k, k, k % 4 != 0));
    together.push_back(drive(k, k / 10, (k / 10) % 4 != 0));
  }
  const Interval narrow = success_over_starts(apart);
  EXPECT_NEAR(narrow.low, 0.75 - 0.0424, 0.004);
  EXPECT_NEAR(narrow.high, 0.75 + 0.0424, 0.004);
  const Interval wide = success_over_starts(together);
  EXPECT_NEAR(wide.low, 0.75 - 0.134, 0.026);
  EXPECT_NEAR(wide.high, 0.75 + 0.134, 0.026);
}

// No drive of 60 failed, in 20 starts: Wilson's interval of 20 of 20 begins at 20 / (20 + 3.84) = 0.839.
TEST(Board, WithoutAFailureStartsCount) {
  std::vector<BoardDrive> drives;
  for (int k = 0; k < 60; ++k) drives.push_back(drive(k, k / 3, true));
  EXPECT_NEAR(success_over_starts(drives).low, 0.839, 0.001);
  EXPECT_DOUBLE_EQ(success_over_starts(drives).high, 1.0);
}

// Of 100 pairs the best succeeds in 90. One that succeeds in 85 of those and in none of the others: five alone, McNemar p
// = 2 / 32 = 0.0625, not shown to be worse. With 84: six alone, p = 2 / 64 = 0.031.
TEST(Board, TellsWhoIsNotShownToBeWorse) {
  BoardSuite suite{
      .name = "s", .whole_graph = false, .rows = {{"near", {}, {}}, {"far", {}, {}}, {"best", {}, {}}}};
  for (int k = 0; k < 100; ++k) {
    suite.rows[0].drives.push_back(drive(k, k, k < 85, 12.0));
    suite.rows[1].drives.push_back(drive(k, k, k < 84, 9.0));
    suite.rows[2].drives.push_back(drive(k, k, k < 90, 11.0));
  }
  const std::vector<BoardFigures> figures = figures_of(suite);
  ASSERT_EQ(figures.size(), 3U);
  EXPECT_EQ(figures[0].planner, "best");
  EXPECT_TRUE(figures[0].wins);
  EXPECT_EQ(figures[1].planner, "near");
  EXPECT_NEAR(figures[1].against_best.p, 0.0625, 1e-12);
  EXPECT_TRUE(figures[1].wins);
  EXPECT_EQ(figures[2].planner, "far");
  EXPECT_NEAR(figures[2].against_best.p, 0.03125, 1e-12);
  EXPECT_FALSE(figures[2].wins);
  EXPECT_DOUBLE_EQ(*figures[0].time, 11.0) << "of those that succeeded";
}

// As good, the faster one stands first.
TEST(Board, TiesGoByTime) {
  BoardSuite suite{.name = "s", .whole_graph = false, .rows = {{"slow", {}, {}}, {"fast", {}, {}}}};
  for (int k = 0; k < 4; ++k) {
    suite.rows[0].drives.push_back(drive(k, k, true, 12.0));
    suite.rows[1].drives.push_back(drive(k, k, true, 9.0));
  }
  EXPECT_EQ(figures_of(suite)[0].planner, "fast");
}

}  // namespace
}  // namespace bw
