#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "components/mapping/costmap/inflation.hpp"
#include "tests/components/mapping/grids.hpp"

namespace bw::costmap {
namespace {

double nearest_obstacle(const OccupancyGrid& grid, int column, int row) {
  double best = std::numeric_limits<double>::infinity();
  for (int r = 0; r < grid.height; ++r) {
    for (int c = 0; c < grid.width; ++c) {
      if (grid.at(c, r) >= 65) best = std::min(best, std::hypot(c - column, r - row));
    }
  }
  return best;
}

// Independent: all pairs of cells, and the formula written out. A cost may differ by one where 252 exp(..) is
// a whole number but for rounding.
TEST(Inflation, EqualsBruteForceOn200RandomMaps) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    OccupancyGrid grid = test::random_grid(random, 1 + static_cast<int>(random.uniform(0, 40)),
                                           1 + static_cast<int>(random.uniform(0, 40)), 0.02);
    for (auto& cell : grid.cells) {
      if (random.uniform() < 0.2) cell = OccupancyGrid::kUnknown;
    }
    const InflationOptions options{.inflation_radius = random.uniform(0.0, 1.0),
                                   .cost_scaling_factor = random.uniform(0.0, 10.0),
                                   .inflate_unknown = random.uniform() < 0.5};
    const double inscribed = random.uniform(0.05, 0.5);
    Inflation inflation(options, inscribed, grid.resolution);
    const std::vector<std::uint8_t>& costs = inflation.costs(grid);
    DistanceTransform transform;
    // Beyond 90 cells by the lower envelope, else by looking around.
    const int reach = static_cast<int>(random.uniform() < 0.5 ? random.uniform(0, 91) : 46340);
    const std::vector<std::int32_t>& squared = transform.squared_cells(grid, {}, reach);
    for (int row = 0; row < grid.height; ++row) {
      for (int column = 0; column < grid.width; ++column) {
        const std::size_t i = grid.index(column, row);
        const double cells = nearest_obstacle(grid, column, row);
        ASSERT_EQ(squared[i], cells > reach ? DistanceTransform::kNone
                                            : static_cast<std::int32_t>(std::lround(cells * cells)));
        const double d = cells * grid.resolution;
        double cost = d > options.inflation_radius ? 0.0
                      : d <= inscribed
                          ? 253.0
                          : std::floor(252.0 * std::exp(-options.cost_scaling_factor * (d - inscribed)));
        if (cells == 0.0) cost = 254.0;
        if (grid.cells[i] < 0 && cost < (options.inflate_unknown ? 1.0 : 253.0)) cost = 255.0;
        if (std::abs(d - options.inflation_radius) < 1e-9 || std::abs(d - inscribed) < 1e-9) continue;
        ASSERT_NEAR(costs[i], cost, cost > 0.0 && cost < 253.0 ? 1.0 : 0.0) << column << "," << row;
      }
    }
  }
}

// Nav2's values by hand: 252 exp(-3 (0.5 - 0.3)) = 252 * 0.548812 = 138.3; 0.3 and nearer 253.
TEST(Inflation, FollowsNav2) {
  const InflationOptions options{.inflation_radius = 0.55, .cost_scaling_factor = 3.0};
  EXPECT_EQ(cost_at(0.0, 0.3, options), 254);
  EXPECT_EQ(cost_at(0.05, 0.3, options), 253);
  EXPECT_EQ(cost_at(0.3, 0.3, options), 253);
  EXPECT_EQ(cost_at(0.5, 0.3, options), 138);
  EXPECT_EQ(cost_at(0.56, 0.3, options), 0);
  EXPECT_EQ(cost_at(std::numeric_limits<double>::infinity(), 0.3, options), 0);
}

// Nav2's table: 0 -> 0, 253 -> 99, 254 -> 100, 255 -> -1, c in 1 to 252 -> 1 + 97 (c - 1) / 251, so 138
// -> 53.
TEST(Inflation, IsPublishedAsNav2Does) {
  EXPECT_EQ(occupancy_of(0), 0);
  EXPECT_EQ(occupancy_of(1), 1);
  EXPECT_EQ(occupancy_of(138), 53);
  EXPECT_EQ(occupancy_of(252), 98);
  EXPECT_EQ(occupancy_of(253), 99);
  EXPECT_EQ(occupancy_of(254), 100);
  EXPECT_EQ(occupancy_of(255), -1);
}

}  // namespace
}  // namespace bw::costmap
