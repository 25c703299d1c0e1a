// Rays against segments, discs and grids: closed forms, and a brute-force search over every solid cell.
#include "components/world/ray.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "components/model/random.hpp"
#include "components/world/grid_scene.hpp"

namespace bw {
namespace {

OccupancyGrid random_grid(Random& random, double solid_share) {
  OccupancyGrid grid;
  grid.resolution = random.uniform(0.02, 0.3);
  grid.origin = {random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0)};
  grid.width = 1 + static_cast<int>(random.uniform(0.0, 60.0));
  grid.height = 1 + static_cast<int>(random.uniform(0.0, 60.0));
  grid.cells.resize(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height));
  for (auto& cell : grid.cells) {
    const double draw = random.uniform();
    cell = draw < solid_share ? OccupancyGrid::kOccupied
           : draw < 0.5       ? OccupancyGrid::kFree
                              : OccupancyGrid::kUnknown;
  }
  return grid;
}

Vector2 random_position(Random& random, const OccupancyGrid& grid) {
  const Vector2 size = grid.resolution * Vector2(grid.width, grid.height);
  return grid.origin + size.cwiseProduct(Vector2(random.uniform(-0.3, 1.3), random.uniform(-0.3, 1.3)));
}

Vector2 low_corner(const OccupancyGrid& grid, int column, int row) {
  return grid.origin + grid.resolution * Vector2(column, row);
}

/// Slab test of one square; written apart from the code under test.
double square_hit(const Vector2& origin, const Vector2& d, const Vector2& low, double edge) {
  double enter = 0.0;
  double leave = kNoHit;
  for (int axis = 0; axis < 2; ++axis) {
    const double t0 = (low[axis] - origin[axis]) / d[axis];
    const double t1 = (low[axis] + edge - origin[axis]) / d[axis];
    enter = std::max(enter, std::min(t0, t1));
    leave = std::min(leave, std::max(t0, t1));
  }
  return enter <= leave ? enter : kNoHit;
}

TEST(Ray, MeetsAWallAtItsDistance) {
  // Wall x = 5: at angle a the range is 5 / cos(a).
  const Segment wall{{5.0, -100.0}, {5.0, 100.0}};
  for (int degrees = -85; degrees <= 85; ++degrees) {
    const double angle = degrees * std::numbers::pi / 180.0;
    EXPECT_NEAR(ray_hit({0.0, 0.0}, direction(angle), wall), 5.0 / std::cos(angle), 1e-9) << degrees;
  }
  EXPECT_EQ(ray_hit({0.0, 0.0}, direction(std::numbers::pi), wall), kNoHit);
  EXPECT_EQ(ray_hit({0.0, 0.0}, {0.0, 1.0}, wall), kNoHit);
}

TEST(Ray, MeetsTheNearEndOfAWallSeenEndOn) {
  const Segment wall{{7.0, 0.0}, {3.0, 0.0}};
  EXPECT_EQ(ray_hit({0.0, 0.0}, {1.0, 0.0}, wall), 3.0);
  EXPECT_EQ(ray_hit({5.0, 0.0}, {1.0, 0.0}, wall), 0.0);
  EXPECT_EQ(ray_hit({8.0, 0.0}, {1.0, 0.0}, wall), kNoHit);
}

TEST(Ray, MeetsADiscAtItsRim) {
  const Disc disc{{4.0, 0.0}, 0.5};
  EXPECT_NEAR(ray_hit({0.0, 0.0}, {1.0, 0.0}, disc), 3.5, 1e-12);
  // Offset 0.3 from the centre line: half chord sqrt(0.25 - 0.09) = 0.4.
  EXPECT_NEAR(ray_hit({0.0, 0.3}, {1.0, 0.0}, disc), 3.6, 1e-12);
  EXPECT_EQ(ray_hit({0.0, 0.51}, {1.0, 0.0}, disc), kNoHit);
  EXPECT_EQ(ray_hit({0.0, 0.0}, {-1.0, 0.0}, disc), kNoHit);
  EXPECT_EQ(ray_hit({4.1, 0.0}, {1.0, 0.0}, disc), 0.0);
}

TEST(GridScene, RayMeetsTheFaceOfAKnownCell) {
  // Column 60 of 0.05 m cells from x = -1 begins at x = 2.
  OccupancyGrid grid{0.05, {-1.0, -1.0}, 100, 40, std::vector<std::int8_t>(4000, 0)};
  for (int row = 0; row < 40; ++row) grid.cells[grid.index(60, row)] = OccupancyGrid::kOccupied;
  const GridScene scene(grid);
  EXPECT_NEAR(scene.ray_hit({0.5, 0.0}, {1.0, 0.0}, 10.0), 1.5, 1e-9);
  EXPECT_NEAR(scene.ray_hit({-6.0, 0.0}, {1.0, 0.0}, 10.0), 8.0, 1e-9) << "from outside the grid";
  EXPECT_NEAR(scene.ray_hit({0.5, 0.0}, direction(0.3), 10.0), 1.5 / std::cos(0.3), 1e-9);
  EXPECT_EQ(scene.ray_hit({0.5, 0.0}, {1.0, 0.0}, 1.49), kNoHit) << "beyond max_range";
  EXPECT_EQ(scene.ray_hit({0.5, 0.0}, {-1.0, 0.0}, 10.0), kNoHit);
  EXPECT_EQ(scene.ray_hit({2.02, 0.0}, {-1.0, 0.0}, 10.0), 0.0) << "from inside a solid cell";
}

TEST(GridScene, RaysAgreeWithBruteForceOnRandomGrids) {
  Random random(20260101);
  int hits = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const OccupancyGrid grid = random_grid(random, random.uniform(0.0, 0.1));
    const GridScene scene(grid);
    for (int ray = 0; ray < 40; ++ray) {
      const Vector2 origin = random_position(random, grid);
      const Vector2 d = direction(random.uniform(-std::numbers::pi, std::numbers::pi));
      double expected = kNoHit;
      for (int row = 0; row < grid.height; ++row) {
        for (int column = 0; column < grid.width; ++column) {
          if (grid.at(column, row) != OccupancyGrid::kOccupied) continue;
          expected =
              std::min(expected, square_hit(origin, d, low_corner(grid, column, row), grid.resolution));
        }
      }
      const double range = scene.ray_hit(origin, d, 100.0);
      if (expected == kNoHit) {
        EXPECT_EQ(range, kNoHit) << "trial " << trial;
      } else {
        EXPECT_NEAR(range, expected, 1e-9) << "trial " << trial;
        ++hits;
      }
    }
  }
  EXPECT_GT(hits, 2000);
}

TEST(GridScene, NearestPointAgreesWithBruteForceOnRandomGrids) {
  Random random(20260102);
  for (int trial = 0; trial < 300; ++trial) {
    const OccupancyGrid grid = random_grid(random, random.uniform(0.0, 0.05));
    const GridScene scene(grid);
    for (int query = 0; query < 40; ++query) {
      const Vector2 point = random_position(random, grid);
      const double limit = random.uniform(0.0, 5.0);
      double expected = kNoHit;
      for (int row = 0; row < grid.height; ++row) {
        for (int column = 0; column < grid.width; ++column) {
          if (grid.at(column, row) != OccupancyGrid::kOccupied) continue;
          const Vector2 low = low_corner(grid, column, row);
          const Vector2 high = low_corner(grid, column + 1, row + 1);
          const double dx = std::max({low.x() - point.x(), point.x() - high.x(), 0.0});
          const double dy = std::max({low.y() - point.y(), point.y() - high.y(), 0.0});
          expected = std::min(expected, std::hypot(dx, dy));
        }
      }
      const auto nearest = scene.nearest_point(point, limit);
      ASSERT_EQ(nearest.has_value(), expected <= limit) << "trial " << trial;
      if (nearest) {
        EXPECT_NEAR((*nearest - point).norm(), expected, 1e-9) << "trial " << trial;
      }
    }
  }
}

TEST(GridScene, RefusesSizesThatDisagree) {
  const auto build = [](double resolution, int width, int height, std::size_t cells) {
    return GridScene({resolution, {0.0, 0.0}, width, height, std::vector<std::int8_t>(cells, 0)});
  };
  EXPECT_NO_THROW(build(0.05, 3, 2, 6));
  EXPECT_THROW(build(0.05, 3, 2, 7), std::runtime_error);
  EXPECT_THROW(build(0.05, 0, 2, 0), std::runtime_error);
  EXPECT_THROW(build(0.05, -3, -2, 6), std::runtime_error);
  EXPECT_THROW(build(0.0, 3, 2, 6), std::runtime_error);
  EXPECT_THROW(build(std::nan(""), 3, 2, 6), std::runtime_error);
}

}  // namespace
}  // namespace bw
