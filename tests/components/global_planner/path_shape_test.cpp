#include "components/global_planner/path_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "components/model/random.hpp"
#include "tests/components/global_planner/random_floor.hpp"

namespace bw {
namespace {

GridCell cell_at(const SearchGrid& grid, const Pose2& pose) {
  const auto [x, y] = grid.cell_of(pose.position());
  return {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)};
}

// Against points sampled along the line: a free line passes free cells only, and its cost is their mean times
// length.
TEST(LineOfSight, AgreesWithDenseSampling) {
  Random random(11);
  const OccupancyGrid map = test::random_floor(random, 200);
  SearchGrid grid;
  grid.build(map, Footprint{0.2, {}}, {});
  int free_lines = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto point = [&]() -> Vector2 {
      return map.origin + Vector2{random.uniform(0.1, 9.9), random.uniform(0.1, 9.9)};
    };
    const Vector2 a = point();
    const Vector2 b = a + Vector2{random.normal(), random.normal()};
    if (!grid.on_map(b)) continue;
    const LineOfSight line = line_of_sight(grid, a, b);
    bool free = true;
    double cost = 0.0;
    float clearance = 1e9F;
    constexpr int kSamples = 4000;
    for (int k = 0; k < kSamples; ++k) {
      const auto [x, y] = grid.cell_of(a + (b - a) * ((k + 0.5) / kSamples));
      free = free && grid.free(x, y);
      cost += (b - a).norm() / kSamples * grid.cells()[grid.index(x, y)].cost / kUnit;
      clearance = std::min(clearance, grid.clearance(x, y));
    }
    if (!line.free) continue;  // it may touch a corner that the samples step over
    ++free_lines;
    EXPECT_TRUE(free);
    EXPECT_NEAR(line.cost, cost, 0.005 * cost + 1e-3);
    EXPECT_LE(line.clearance, clearance);
  }
  EXPECT_GT(free_lines, 200);
}

// A line exactly through the corner between two blocked cells touches them.
TEST(LineOfSight, DoesNotPassBetweenTwoCellsThatTouchAtACorner) {
  OccupancyGrid map{.resolution = 1.0, .width = 4, .height = 4};
  map.cells.assign(16, OccupancyGrid::kFree);
  map.cells[map.index(1, 2)] = OccupancyGrid::kOccupied;
  SearchGrid grid;
  grid.build(map, Footprint{0.1, {}}, {});
  EXPECT_FALSE(line_of_sight(grid, {1.5, 1.5}, {2.5, 2.5}).free);
  EXPECT_TRUE(line_of_sight(grid, {1.5, 1.5}, {3.5, 1.5}).free);
}

// Over 100 floors: shorter than the staircase, never dearer by more than the leeway of one cell per corner,
// never in a blocked cell, never closer to obstacles than the staircase was (by more than a cell).
TEST(Shorten, NeverLeavesFreeSpaceNorTheClearanceOfTheSearch) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const OccupancyGrid map = test::random_floor(random, 200);
    SearchGrid grid;
    grid.build(map, Footprint{0.25, {}}, {});
    const test::Trip trip = test::random_trip(random, grid, map);
    const GridPath path = AStar().search(grid, cell_at(grid, trip.start), cell_at(grid, trip.goal));
    const std::vector<Vector2> corners = shorten(grid, path, trip.start.position(), trip.goal.position());
    double cost = 0.0;
    double length = 0.0;
    float clearance = 1e9F;
    for (std::size_t i = 1; i < corners.size(); ++i) {
      const LineOfSight line = line_of_sight(grid, corners[i - 1], corners[i]);
      ASSERT_TRUE(line.free);
      cost += line.cost;
      clearance = std::min(clearance, line.clearance);
      length += (corners[i] - corners[i - 1]).norm();
    }
    double staircase = 0.0;
    float staircase_clearance = 1e9F;
    for (std::size_t i = 0; i < path.cells.size(); ++i) {
      const GridCell& c = path.cells[i];
      staircase_clearance = std::min(staircase_clearance, grid.clearance(c.x, c.y));
      if (i == 0) continue;
      staircase += map.resolution * std::hypot(c.x - path.cells[i - 1].x, c.y - path.cells[i - 1].y);
    }
    EXPECT_LE(length, staircase + 1e-9);
    EXPECT_LT(corners.size(), path.cells.size());
    EXPECT_LE(cost, map.resolution *
                        (path.cost_so_far.back() / double{kUnit} + static_cast<double>(corners.size())));
    EXPECT_GE(clearance, staircase_clearance - static_cast<float>(map.resolution));
  }
}

// An L of 1 m and 0.5 m at 0.25 m: 4 + 2 poses along the lines and the goal itself, which keeps its heading.
TEST(Sample, GivesTangentHeadingsAndKeepsTheGoals) {
  const std::vector<Pose2> path = sample({{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.5}}, 0.25, -2.0);
  ASSERT_EQ(path.size(), 7u);
  EXPECT_EQ(path[0], (Pose2{0.0, 0.0, 0.0}));
  EXPECT_DOUBLE_EQ(path[3].x, 0.75);
  EXPECT_DOUBLE_EQ(path[4].theta, std::numbers::pi / 2.0);
  EXPECT_EQ(path[6], (Pose2{1.0, 0.5, -2.0}));
}

TEST(Sample, StandsStillWhenStartIsGoal) {
  EXPECT_EQ(sample({{2.0, 3.0}, {2.0, 3.0}}, 0.1, 1.0), (std::vector<Pose2>{{2.0, 3.0, 1.0}}));
}

}  // namespace
}  // namespace bw
