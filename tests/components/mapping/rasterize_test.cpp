#include "components/mapping/rasterize.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/components/mapping/grids.hpp"

namespace bw {
namespace {

// Points of the segment, at 1000 fractions: the cell of each must be occupied; nothing farther than one cell
// may be.
TEST(Rasterize, CoversEverySegmentAndLittleMore) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    OccupancyGrid grid = test::empty_grid(40, 30, 0.1, {-2.0, -1.5});
    const auto point = [&] { return Vector2{random.uniform(-3.0, 3.0), random.uniform(-2.5, 2.5)}; };
    const Segment s{point(), point()};
    draw_segment(grid, s);
    for (int i = 0; i <= 1000; ++i) {
      const Vector2 p = s.a + (s.b - s.a) * (i / 1000.0);
      const int column = grid.column_of(p.x());
      const int row = grid.row_of(p.y());
      if (!grid.contains(column, row)) continue;
      ASSERT_EQ(grid.at(column, row), OccupancyGrid::kOccupied) << p.transpose();
    }
    for (int row = 0; row < grid.height; ++row) {
      for (int column = 0; column < grid.width; ++column) {
        if (grid.at(column, row) != OccupancyGrid::kOccupied) continue;
        const Vector2 c = grid.center(column, row);
        const Vector2 d = s.b - s.a;
        const double t = std::clamp((c - s.a).dot(d) / d.squaredNorm(), 0.0, 1.0);
        // A cell that touches the segment has its centre within half a diagonal.
        ASSERT_LE((c - s.a - t * d).norm(), 0.1 * std::numbers::sqrt2 / 2.0 + 1e-9);
      }
    }
  }
}

TEST(Rasterize, DrawsAxisParallelSegmentsAndPoints) {
  OccupancyGrid grid = test::empty_grid(10, 10, 1.0);
  draw_segment(grid, {{1.5, 2.5}, {4.5, 2.5}});
  draw_segment(grid, {{7.5, 1.5}, {7.5, 3.5}});
  draw_segment(grid, {{0.5, 8.5}, {0.5, 8.5}});
  int occupied = 0;
  for (const auto cell : grid.cells) occupied += cell == OccupancyGrid::kOccupied ? 1 : 0;
  EXPECT_EQ(occupied, 4 + 3 + 1);
  EXPECT_EQ(grid.at(4, 2), OccupancyGrid::kOccupied);
  EXPECT_EQ(grid.at(7, 3), OccupancyGrid::kOccupied);
  EXPECT_EQ(grid.at(0, 8), OccupancyGrid::kOccupied);
}

// 0.05 is no binary fraction: the line between two rows and the row that a wall along it falls into are
// rounded apart, and walls along some of these lines were in no row.
TEST(Rasterize, DrawsWallsAlongTheLinesBetweenCells) {
  for (int line = -100; line <= 100; ++line) {
    OccupancyGrid grid = test::empty_grid(20, 210, 0.05, {0.0, 0.05 * -102.0});
    const double y = line / 20.0;
    draw_segment(grid, {{0.125, y}, {0.875, y}});
    for (int column = 2; column <= 17; ++column)
      ASSERT_EQ(grid.at(column, grid.row_of(y)), OccupancyGrid::kOccupied)
          << "y " << y << ", column " << column;
  }
}

TEST(Rasterize, FillsBoxesFromAnyCorner) {
  OccupancyGrid grid = test::empty_grid(10, 10, 1.0);
  draw_box(grid, {4.2, 6.9}, {2.5, 5.1});
  int occupied = 0;
  for (const auto cell : grid.cells) occupied += cell == OccupancyGrid::kOccupied ? 1 : 0;
  EXPECT_EQ(occupied, 3 * 2);  // columns 2, 3, 4 and rows 5, 6
}

TEST(Rasterize, ClipsHugeShapesAndIgnoresNonFiniteOnes) {
  OccupancyGrid grid = test::empty_grid(4, 4, 1.0);
  draw_segment(grid, {{std::numeric_limits<double>::quiet_NaN(), 0.0}, {1.0, 1.0}});
  draw_box(grid, {0.0, 0.0}, {std::numeric_limits<double>::infinity(), 1.0});
  for (const auto cell : grid.cells) EXPECT_EQ(cell, OccupancyGrid::kFree);
  draw_segment(grid, {{-1e30, 1.5}, {1e30, 1.5}});
  for (int column = 0; column < 4; ++column) EXPECT_EQ(grid.at(column, 1), OccupancyGrid::kOccupied);
  draw_box(grid, {-1e300, -1e300}, {1e300, 1e300});
  for (const auto cell : grid.cells) EXPECT_EQ(cell, OccupancyGrid::kOccupied);
}

// Cells whose centre lies inside the disc are occupied; none that lies farther out than the polygon's corner
// (radius / cos(pi / 16)) and half a cell's diagonal.
TEST(Rasterize, CoversADiscAndLittleMore) {
  OccupancyGrid grid = test::empty_grid(40, 30, 0.1, {-2.0, -1.5});
  const Disc disc{{0.33, -0.21}, 0.7};
  draw_disc(grid, disc);
  const double farthest = disc.radius / std::cos(std::numbers::pi / 16.0) + 0.1 * std::numbers::sqrt2 / 2.0;
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      const double distance = (grid.center(column, row) - disc.center).norm();
      const bool drawn = grid.at(column, row) == OccupancyGrid::kOccupied;
      EXPECT_TRUE(drawn || distance > disc.radius) << distance;
      EXPECT_TRUE(!drawn || distance <= farthest) << distance;
    }
  }
}

// The reference: round a point inside, the angles to the corners add up to whole turns.
int turns_round(const std::vector<Vector2>& corners, const Vector2& p) {
  double sum = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2 a = corners[i] - p;
    const Vector2 b = corners[(i + 1) % corners.size()] - p;
    sum += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  return static_cast<int>(std::lround(sum / (2.0 * std::numbers::pi)));
}

// By hand lines cross themselves. Cells whose middle it goes round, and those that it touches; and erased the
// same way nothing is left of them.
TEST(Rasterize, FillsWhateverALineByHandGoesRound) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::vector<Vector2> corners;
    for (int i = 0; i < 7; ++i) corners.emplace_back(random.uniform(-3.0, 3.0), random.uniform(-2.5, 2.5));
    OccupancyGrid grid = test::empty_grid(40, 30, 0.1, {-2.0, -1.5});
    OccupancyGrid outline = grid;
    for (std::size_t i = 0; i < corners.size(); ++i)
      draw_segment(outline, {corners[i], corners[(i + 1) % corners.size()]});
    draw_polygon(grid, corners, 77);
    for (int row = 0; row < grid.height; ++row) {
      for (int column = 0; column < grid.width; ++column) {
        const bool is_in = turns_round(corners, grid.center(column, row)) != 0 ||
                           outline.at(column, row) == OccupancyGrid::kOccupied;
        ASSERT_EQ(grid.at(column, row), is_in ? 77 : 0) << column << ", " << row;
      }
    }
    draw_polygon(grid, corners, OccupancyGrid::kFree);
    ASSERT_EQ(grid.cells, test::empty_grid(40, 30, 0.1).cells);
  }
}

// One corner 1.2 cells to the left, one 2.5 cells above: 2 columns and 3 rows more, and all stays where it
// was.
TEST(Rasterize, AGridGrowsByWholeUnknownCells) {
  OccupancyGrid grid = test::empty_grid(4, 2, 0.5, {1.0, 1.0});
  grid.cells[grid.index(3, 1)] = OccupancyGrid::kOccupied;
  ASSERT_TRUE(grow_to_hold(grid, {{0.4, 1.2}, {2.0, 3.25}}, 30.0));
  EXPECT_EQ(grid.width, 6);
  EXPECT_EQ(grid.height, 5);
  EXPECT_EQ(grid.origin, Vector2(0.0, 1.0));
  EXPECT_EQ(grid.at(grid.column_of(2.75), grid.row_of(1.75)), OccupancyGrid::kOccupied);
  EXPECT_EQ(grid.at(1, 0), OccupancyGrid::kUnknown);
  EXPECT_EQ(grid.at(2, 0), OccupancyGrid::kFree);
  EXPECT_FALSE(grow_to_hold(grid, {{-0.1, 1.0}}, 30.0));
  EXPECT_FALSE(grow_to_hold(grid, {{1e38, -1e38}}, 30.0));
  EXPECT_EQ(grid.width, 6);
}

}  // namespace
}  // namespace bw
