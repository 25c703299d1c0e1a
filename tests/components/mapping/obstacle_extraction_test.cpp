#include "components/mapping/obstacle_extraction.hpp"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "components/mapping/rasterize.hpp"
#include "tests/components/mapping/grids.hpp"

namespace bw {
namespace {

double distance_to(const Vector2& p, const Segment& s) {
  const Vector2 d = s.b - s.a;
  const double t = d.squaredNorm() > 0.0 ? std::clamp((p - s.a).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0.0;
  return (p - s.a - t * d).norm();
}

double distance_to(const Vector2& p, const StaticObstacles& obstacles) {
  double best = std::numeric_limits<double>::infinity();
  for (const Vector2& q : obstacles.points) best = std::min(best, (p - q).norm());
  for (const Segment& s : obstacles.segments) best = std::min(best, distance_to(p, s));
  for (const Disc& d : obstacles.discs) best = std::min(best, std::abs((p - d.center).norm() - d.radius));
  return best;
}

std::vector<Vector2> boundary_cells(const OccupancyGrid& grid, const Vector2& position, double radius) {
  std::vector<Vector2> result;
  const auto is_free = [&](int c, int r) { return grid.contains(c, r) && grid.at(c, r) < 65; };
  for (int r = 0; r < grid.height; ++r) {
    for (int c = 0; c < grid.width; ++c) {
      if (grid.at(c, r) < 65 || (grid.center(c, r) - position).norm() > radius) continue;
      if (is_free(c + 1, r) || is_free(c - 1, r) || is_free(c, r + 1) || is_free(c, r - 1)) {
        result.push_back(grid.center(c, r));
      }
    }
  }
  return result;
}

OccupancyGrid random_room(Random& random) {
  OccupancyGrid grid = test::empty_grid(160, 160, 0.05, {-4.0, -4.0});
  for (int i = 0; i < 6; ++i) {
    const Vector2 a{random.uniform(-4, 4), random.uniform(-4, 4)};
    draw_segment(grid, {a, a + Vector2{random.uniform(-3, 3), random.uniform(-3, 3)}});
    draw_box(grid, a, a + Vector2{random.uniform(-1, 1), random.uniform(-1, 1)});
  }
  for (int i = 0; i < 20; ++i) {
    grid.cells[grid.index(static_cast<int>(random.uniform(0, 160)),
                          static_cast<int>(random.uniform(0, 160)))] = 100;
  }
  return grid;
}

// The guarantee of the header, against an independent scan for boundary cells.
TEST(ObstacleExtraction, KeepsEveryBoundaryCellWithinHalfACell) {
  std::size_t most = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const OccupancyGrid grid = random_room(random);
    const Vector2 position{random.uniform(-4, 4), random.uniform(-4, 4)};
    const ExtractionResult result = extract_obstacles(grid, position, {});
    const std::vector<Vector2> cells = boundary_cells(grid, position, 4.0);
    ASSERT_EQ(result.boundary_cells, cells.size());
    for (const Vector2& cell : cells) ASSERT_LE(distance_to(cell, result.obstacles), 0.025 + 1e-9);
    most = std::max(most, result.obstacles.size());
  }
  RecordProperty("most_shapes", static_cast<int>(most));
  EXPECT_LE(most, 200u);  // so few do for these rooms
}

// A third of all cells at random: thousands of shapes, where 200 were kept once.
TEST(ObstacleExtraction, DropsNothingHoweverManyThereAre) {
  Random random(3);
  const OccupancyGrid grid = test::random_grid(random, 160, 160, 0.1);
  const Vector2 position = grid.center(80, 80);
  const double radius = 60 * grid.resolution;
  const ExtractionResult result = extract_obstacles(grid, position, {.radius = radius});
  EXPECT_GT(result.obstacles.size(), 200U);
  EXPECT_FALSE(result.obstacles.discs.empty());
  for (const Vector2& cell : boundary_cells(grid, position, radius)) {
    EXPECT_LE(distance_to(cell, result.obstacles), 0.5 * grid.resolution + 1e-9);
  }
}

// A wall of one cell is one segment through its cell centres: from x = 0.5 to 9.5 at y = 5.5.
TEST(ObstacleExtraction, MakesOneSegmentOfAStraightWall) {
  OccupancyGrid grid = test::empty_grid(10, 10, 1.0);
  draw_segment(grid, {{0.5, 5.5}, {9.5, 5.5}});
  const ExtractionResult result = extract_obstacles(grid, {5.0, 2.0}, {.radius = 20.0});
  ASSERT_EQ(result.obstacles.size(), 1u);
  ASSERT_EQ(result.obstacles.segments.size(), 1u);
  const Segment& s = result.obstacles.segments[0];
  EXPECT_DOUBLE_EQ(std::min(s.a.x(), s.b.x()), 0.5);
  EXPECT_DOUBLE_EQ(std::max(s.a.x(), s.b.x()), 9.5);
  EXPECT_DOUBLE_EQ(s.a.y(), 5.5);
  EXPECT_DOUBLE_EQ(s.b.y(), 5.5);
}

// The outline of a filled box has four sides.
TEST(ObstacleExtraction, MakesFourSegmentsOfABox) {
  OccupancyGrid grid = test::empty_grid(40, 40, 0.05);
  draw_box(grid, {0.5, 0.5}, {1.2, 0.9});
  const ExtractionResult result = extract_obstacles(grid, {0.2, 0.2}, {});
  EXPECT_EQ(result.obstacles.points.size(), 0u);
  EXPECT_LE(result.obstacles.segments.size(), 5u);
  EXPECT_GE(result.obstacles.segments.size(), 4u);
}

TEST(ObstacleExtraction, MakesAPointOfALonelyCell) {
  OccupancyGrid grid = test::empty_grid(40, 40, 0.05);
  grid.cells[grid.index(10, 20)] = OccupancyGrid::kOccupied;
  const ExtractionResult result = extract_obstacles(grid, {1.0, 1.0}, {});
  ASSERT_EQ(result.obstacles.points.size(), 1u);
  EXPECT_TRUE(result.obstacles.points[0].isApprox(Vector2{0.525, 1.025}));
}

// A pillar of 0.2 m radius at (1, 1), drawn cell by cell: one disc whose rim runs through the outermost
// cells.
TEST(ObstacleExtraction, MakesADiscOfAPillar) {
  OccupancyGrid grid = test::empty_grid(40, 40, 0.05);
  for (int row = 0; row < 40; ++row) {
    for (int column = 0; column < 40; ++column) {
      if ((grid.center(column, row) - Vector2{1.0, 1.0}).norm() <= 0.2)
        grid.cells[grid.index(column, row)] = 100;
    }
  }
  const ExtractionResult result = extract_obstacles(grid, {0.2, 0.2}, {});
  ASSERT_EQ(result.obstacles.size(), 1u);
  ASSERT_EQ(result.obstacles.discs.size(), 1u);
  EXPECT_TRUE(result.obstacles.discs[0].center.isApprox(Vector2{1.0, 1.0}, 1e-9));
  EXPECT_NEAR(result.obstacles.discs[0].radius, 0.2, 0.025);
}

// A ring of 0.45 m around the robot is no disc: the robot would stand inside it.
TEST(ObstacleExtraction, KeepsTheWallsOfARingAroundTheRobot) {
  OccupancyGrid grid = test::empty_grid(40, 40, 0.05);
  for (int row = 0; row < 40; ++row) {
    for (int column = 0; column < 40; ++column) {
      const double distance = (grid.center(column, row) - Vector2{1.0, 1.0}).norm();
      if (distance > 0.4 && distance < 0.46) grid.cells[grid.index(column, row)] = 100;
    }
  }
  const ExtractionResult result = extract_obstacles(grid, {1.0, 1.0}, {});
  EXPECT_TRUE(result.obstacles.discs.empty());
  EXPECT_GE(distance_to({1.0, 1.0}, result.obstacles), 0.4 - 0.025);
}

// A wall of two cells with unknown behind it is one segment, on the free side; two when unknown counts as
// free.
TEST(ObstacleExtraction, OutlinesWallsOnTheirFreeSide) {
  OccupancyGrid grid = test::empty_grid(20, 20, 0.1);
  for (int column = 0; column < 20; ++column) {
    for (int row = 10; row < 20; ++row) {
      grid.cells[grid.index(column, row)] = row < 12 ? OccupancyGrid::kOccupied : OccupancyGrid::kUnknown;
    }
  }
  const ExtractionResult result = extract_obstacles(grid, {1.0, 0.5}, {});
  ASSERT_EQ(result.obstacles.segments.size(), 1u);
  EXPECT_DOUBLE_EQ(result.obstacles.segments[0].a.y(), 1.05);
  EXPECT_GT(extract_obstacles(grid, {1.0, 0.5}, {.face_unknown = true}).obstacles.segments.size(), 1u);
}

TEST(ObstacleExtraction, GivesNothingForNonsense) {
  const OccupancyGrid grid = test::empty_grid(40, 40, 0.05);
  EXPECT_EQ(extract_obstacles(grid, {std::numeric_limits<double>::quiet_NaN(), 0.0}, {}).obstacles.size(),
            0u);
  EXPECT_EQ(extract_obstacles(grid, {1e300, -1e300}, {}).obstacles.size(), 0u);
  EXPECT_EQ(extract_obstacles(OccupancyGrid{}, {0.0, 0.0}, {}).obstacles.size(), 0u);
}

}  // namespace
}  // namespace bw
