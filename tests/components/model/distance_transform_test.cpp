#include "components/model/distance_transform.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/components/mapping/grids.hpp"

namespace bw {
namespace {

float brute_force(const OccupancyGrid& grid, const ObstacleRule& rule, int column, int row) {
  long best = -1;
  for (int r = 0; r < grid.height; ++r) {
    for (int c = 0; c < grid.width; ++c) {
      if (!rule.blocks(grid.at(c, r))) continue;
      const long squared = long{c - column} * (c - column) + long{r - row} * (r - row);
      if (best < 0 || squared < best) best = squared;
    }
  }
  return best < 0 ? std::numeric_limits<float>::infinity()
                  : static_cast<float>(std::sqrt(static_cast<double>(best)) * grid.resolution);
}

// Independent: all pairs of cells. The field is computed from integers, so the values are the same floats.
TEST(DistanceTransform, EqualsBruteForceOn200RandomGrids) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const int width = 1 + static_cast<int>(random.uniform(0, 40));
    const int height = 1 + static_cast<int>(random.uniform(0, 40));
    const OccupancyGrid grid = test::random_grid(random, width, height, std::pow(random.uniform(), 3));
    const std::vector<float> field = distance_field(grid, {});
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) {
        ASSERT_EQ(field[grid.index(column, row)], brute_force(grid, {}, column, row)) << column << "," << row;
      }
    }
  }
}

TEST(DistanceTransform, IsInfiniteWithoutObstacles) {
  const OccupancyGrid grid = test::empty_grid(30, 20);
  for (const float d : distance_field(grid, {})) EXPECT_EQ(d, std::numeric_limits<float>::infinity());
}

// One obstacle at (3, 4) cells of 0.1 m from the corner: sqrt(3^2 + 4^2) * 0.1 = 0.5 m.
TEST(DistanceTransform, MeasuresMetres) {
  OccupancyGrid grid = test::empty_grid(10, 10, 0.1);
  grid.cells[grid.index(3, 4)] = OccupancyGrid::kOccupied;
  EXPECT_FLOAT_EQ(distance_field(grid, {})[0], 0.5F);
}

TEST(DistanceTransform, TreatsUnknownByTheRule) {
  OccupancyGrid grid = test::empty_grid(5, 1, 1.0);
  grid.cells[4] = OccupancyGrid::kUnknown;
  EXPECT_EQ(distance_field(grid, {})[0], std::numeric_limits<float>::infinity());
  EXPECT_EQ(distance_field(grid, {.unknown_is_obstacle = true})[0], 4.0F);
}

TEST(DistanceTransform, AcceptsAnEmptyGrid) { EXPECT_TRUE(distance_field(OccupancyGrid{}, {}).empty()); }

}  // namespace
}  // namespace bw
