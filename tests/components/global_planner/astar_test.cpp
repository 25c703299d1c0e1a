#include "components/global_planner/astar.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "components/global_planner/planner.hpp"
#include "components/model/random.hpp"
#include "tests/components/global_planner/dijkstra_oracle.hpp"
#include "tests/components/global_planner/random_floor.hpp"

namespace bw {
namespace {

GridCell random_cell(Random& random, const OccupancyGrid& map) {
  return {static_cast<std::uint16_t>(1 + random.uniform(0, map.width)),
          static_cast<std::uint16_t>(1 + random.uniform(0, map.height))};
}

// 1,000 random maps (seeds 1 to 1000), five start-goal pairs each: reachable exactly when Dijkstra says so,
// and then the cost ratio is 1 within 1e-4 (integer costs against doubles).
TEST(AStar, IsOptimalAgainstDijkstraOn1000RandomMaps) {
  std::size_t paths = 0;
  double worst = 0.0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const int width = 8 + static_cast<int>(random.uniform(0, 50));
    const int height = 8 + static_cast<int>(random.uniform(0, 50));
    OccupancyGrid map{.resolution = random.uniform(0.03, 0.2), .width = width, .height = height};
    map.cells.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                     OccupancyGrid::kFree);
    const double density = 0.25 * random.uniform() * random.uniform();
    for (auto& cell : map.cells) {
      const double u = random.uniform();
      if (u < density) cell = u < density / 5 ? OccupancyGrid::kUnknown : OccupancyGrid::kOccupied;
    }
    const double radius = random.uniform(0.0, 1.6) * map.resolution;
    const GlobalPlannerOptions options{.clearance_range = random.uniform(0.0, 10.0) * map.resolution,
                                       .clearance_weight = random.uniform(0.0, 10.0),
                                       .unknown_is_obstacle = random.uniform() < 0.5};
    SearchGrid grid;
    grid.build(map, Footprint{radius, {}}, options);
    const test::DijkstraOracle oracle(map, radius, options, grid);
    AStar search;
    for (int i = 0; i < 5; ++i) {
      const GridCell start = random_cell(random, map);
      const GridCell goal = random_cell(random, map);
      ASSERT_EQ(grid.free(start.x, start.y), oracle.free(start.x - 1, start.y - 1));
      if (!grid.free(start.x, start.y) || !grid.free(goal.x, goal.y)) continue;
      const double expected = oracle.cost(start.x - 1, start.y - 1, goal.x - 1, goal.y - 1);
      ASSERT_EQ(std::isfinite(expected), grid.component(start.x, start.y) == grid.component(goal.x, goal.y));
      const GridPath path = search.search(grid, start, goal);
      ASSERT_EQ(path.cells.empty(), !std::isfinite(expected));
      if (path.cells.empty() || start == goal) continue;
      ++paths;
      const double cost = map.resolution * path.cost_so_far.back() / kUnit;
      worst = std::max(worst, std::abs(cost / expected - 1.0));
      ASSERT_NEAR(cost / expected, 1.0, 1e-4);
      ASSERT_EQ(path.cells.front(), start);
      ASSERT_EQ(path.cells.back(), goal);
    }
  }
  RecordProperty("paths", static_cast<int>(paths));
  std::printf("%zu paths, worst cost ratio off by %.1e\n", paths, worst);
  EXPECT_GT(paths, 2000u);
}

// Every step is to a neighbour, through free cells, and cuts no corner; the costs add up.
TEST(AStar, StepsAreAllowedAndCostsAddUp) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const OccupancyGrid map = test::random_floor(random, 200);
    SearchGrid grid;
    grid.build(map, Footprint{0.3, {}}, {});
    AStar search;
    const test::Trip trip = test::random_trip(random, grid, map);
    const auto [x0, y0] = grid.cell_of(trip.start.position());
    const auto [x1, y1] = grid.cell_of(trip.goal.position());
    const GridPath path =
        search.search(grid, {static_cast<std::uint16_t>(x0), static_cast<std::uint16_t>(y0)},
                      {static_cast<std::uint16_t>(x1), static_cast<std::uint16_t>(y1)});
    ASSERT_GT(path.cells.size(), 70u);  // half a side along the diagonal
    for (std::size_t i = 1; i < path.cells.size(); ++i) {
      const GridCell& a = path.cells[i - 1];
      const GridCell& b = path.cells[i];
      ASSERT_EQ(std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)), 1);
      ASSERT_TRUE(grid.free(b.x, b.y));
      // In narrow cells the path from position to position counts, and the robot may reach into a blocked
      // cell's corner.
      if (grid.narrow(a.x, a.y) != nullptr || grid.narrow(b.x, b.y) != nullptr) {
        ASSERT_TRUE(grid.holds((grid.position(a.x, a.y) + grid.position(b.x, b.y)) / 2.0));
      } else {
        ASSERT_TRUE(grid.free(a.x, b.y) && grid.free(b.x, a.y));
      }
      const std::uint32_t cost = grid.cells()[grid.index(b.x, b.y)].cost;
      ASSERT_EQ(path.cost_so_far[i], path.cost_so_far[i - 1] + step_cost(cost, a.x != b.x && a.y != b.y));
    }
  }
}

// Stamps are 8 bits: after 600 searches they have wrapped twice, and answers are still those of a fresh
// search.
TEST(AStar, StampsWrapWithoutATrace) {
  Random random(5);
  const OccupancyGrid map = test::random_floor(random, 100);
  SearchGrid grid;
  grid.build(map, Footprint{0.2, {}}, {});
  SearchGrid fresh_grid = grid;
  AStar search;
  for (int i = 0; i < 600; ++i) {
    const GridCell start = random_cell(random, map);
    const GridCell goal = random_cell(random, map);
    if (!grid.free(start.x, start.y) || !grid.free(goal.x, goal.y)) continue;
    const GridPath path = search.search(grid, start, goal);
    SearchGrid copy = fresh_grid;
    AStar fresh;
    ASSERT_EQ(path.cells, fresh.search(copy, start, goal).cells) << i;
  }
}

// On an empty map the octile distance is the cost: 30 straight and 20 diagonal steps.
TEST(AStar, FollowsTheOctileDistanceInTheOpen) {
  OccupancyGrid map{.resolution = 1.0, .width = 60, .height = 60};
  map.cells.assign(3600, OccupancyGrid::kFree);
  SearchGrid grid;
  grid.build(map, Footprint{0.3, {}}, {});
  const GridPath path = AStar().search(grid, {1, 1}, {51, 21});
  ASSERT_FALSE(path.cells.empty());
  EXPECT_EQ(path.cost_so_far.back(), 30 * kUnit + 20 * kDiagonalUnit);
  // Ties to the larger g: the search runs straight to the goal instead of filling the parallelogram of equal
  // f.
  EXPECT_EQ(path.expanded, 50u);
}

}  // namespace
}  // namespace bw
