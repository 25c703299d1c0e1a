#include "components/slam/map_rendering.hpp"

#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/components/slam/slam_scene.hpp"

namespace bw::slam {
namespace {

RangeImage one_beam(double metres, double angle = 0.0) {
  RangeImage image;
  image.angle_min = angle;
  image.angle_increment = 0.01;
  image.millimetres.push_back(static_cast<std::uint16_t>(std::lround(1000.0 * metres)));
  return image;
}

std::int8_t value_at(const OccupancyGrid& grid, double x, double y) {
  const int column = grid.column_of(x);
  const int row = grid.row_of(y);
  return grid.contains(column, row) ? grid.at(column, row) : OccupancyGrid::kUnknown;
}

// Length of the part of segment a-b inside cell (i, j).
double length_within(const Vector2& a, const Vector2& b, int i, int j, double edge) {
  double from = 0.0;
  double to = 1.0;
  const Vector2 low{i * edge, j * edge};
  for (int axis = 0; axis < 2; ++axis) {
    const double d = b(axis) - a(axis);
    const double enter = (low(axis) - a(axis)) / d;
    const double leave = (low(axis) + edge - a(axis)) / d;
    from = std::max(from, std::min(enter, leave));
    to = std::min(to, std::max(enter, leave));
  }
  return std::max(0.0, to - from) * (b - a).norm();
}

// 1 m along x from the middle of cell (0, 0): cells 0 to 19 are free, cell 20 is occupied. The grid begins a
// tile of 32 cells below tile 0 and ends a tile after it.
TEST(MapRendering, OneBeamIsItsCells) {
  MapRendering map(0.05);
  map.draw(one_beam(1.0), {0.025, 0.025, 0.0});
  const OccupancyGrid grid = map.grid();
  EXPECT_EQ(grid.width, 96);
  EXPECT_EQ(grid.height, 96);
  EXPECT_NEAR(grid.origin.x(), -1.6, 1e-12);
  EXPECT_NEAR(grid.origin.y(), -1.6, 1e-12);
  for (int row = 0; row < 96; ++row) {
    for (int column = 0; column < 96; ++column) {
      std::int8_t expected = OccupancyGrid::kUnknown;
      if (row == 32 && column >= 32 && column < 52) expected = OccupancyGrid::kFree;
      if (row == 32 && column == 52) expected = OccupancyGrid::kOccupied;
      ASSERT_EQ(grid.at(column, row), expected) << column << ", " << row;
    }
  }
}

// Any beam: what is free are the cells that the segment goes through, clipped one by one, but for the last,
// which is occupied.
TEST(MapRendering, BeamsOfAnyDirectionCrossTheCellsOfTheirSegment) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    const Pose2 X{random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)};
    const double metres = 0.001 * std::round(random.uniform(50.0, 6000.0));
    const double angle = random.uniform(-3, 3);
    MapRendering map(0.05);
    map.draw(one_beam(metres, angle), X);
    const OccupancyGrid grid = map.grid();
    const Vector2 a = X.position();
    const Vector2 b = a + metres * direction(X.theta + angle);
    int occupied = 0;
    for (int row = 0; row < grid.height; ++row) {
      for (int column = 0; column < grid.width; ++column) {
        const std::int8_t value = grid.at(column, row);
        const Vector2 centre = grid.center(column, row);
        const double inside = length_within(a, b, static_cast<int>(std::floor(centre.x() / 0.05)),
                                            static_cast<int>(std::floor(centre.y() / 0.05)), 0.05);
        const bool drawn = value != OccupancyGrid::kUnknown;
        if (drawn != (inside > 0.0) && (inside > 1e-9 || value == OccupancyGrid::kFree))
          ADD_FAILURE() << "seed " << seed << ": " << inside << " m of the beam in a cell of " << int{value};
        occupied += value == OccupancyGrid::kOccupied;
      }
    }
    EXPECT_EQ(occupied, 1);
    EXPECT_EQ(value_at(grid, b.x(), b.y()), OccupancyGrid::kOccupied) << "seed " << seed;
  }
}

TEST(MapRendering, BeamsThatSayNothingDrawNothing) {
  RangeImage image = one_beam(1.0);
  image.millimetres = {RangeImage::kUnknown, RangeImage::kNoReturn};
  MapRendering map(0.05);
  map.draw(image, {});
  EXPECT_EQ(map.grid().width, 0);
  EXPECT_TRUE(map.grid().cells.empty());
}

TEST(MapRendering, WhatIsDrawnAndErasedIsNotThere) {
  test::Scanner scanner(test::square_of_corridors(), 0.01, 1);
  MapRendering map(0.05);
  MapRendering once(0.05);
  std::vector<std::pair<RangeImage, Pose2>> drawn;
  for (int k = 0; k < 10; ++k) {
    const Pose2 X{-5.0 + 0.4 * k, -4.0, 0.1 * k};
    drawn.emplace_back(scanner.scan({}, X).ranges, X);
    map.draw(drawn.back().first, X);
    if (k == 3) once.draw(drawn.back().first, X);
  }
  EXPECT_GT(map.grid().width, 0);
  for (std::size_t k = 0; k < drawn.size(); ++k)
    if (k != 3) map.erase(drawn[k].first, drawn[k].second);
  EXPECT_EQ(map.grid().cells, once.grid().cells) << "the fourth alone is left";
  EXPECT_EQ(map.grid().origin, once.grid().origin);
  map.erase(drawn[3].first, drawn[3].second);
  EXPECT_EQ(map.grid().width, 0);
  EXPECT_TRUE(map.grid().cells.empty());
}

// Occupied from a quarter on: of one hit and three passes, but not of one and four.
TEST(MapRendering, ACellIsOccupiedFromAQuarterOfItsBeams) {
  MapRendering map(0.05);
  const Pose2 X{0.025, 0.025, 0.0};
  map.draw(one_beam(1.0), X);
  for (int k = 0; k < 3; ++k) map.draw(one_beam(2.0), X);
  EXPECT_EQ(value_at(map.grid(), 1.025, 0.025), OccupancyGrid::kOccupied);
  map.draw(one_beam(2.0), X);
  EXPECT_EQ(value_at(map.grid(), 1.025, 0.025), OccupancyGrid::kFree);
}

// Origin and size in steps of a tile, 1.6 m, on all sides of zero, and a margin of a tile about what was
// drawn.
TEST(MapRendering, GridGrowsInStepsOfATile) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Random random(seed);
    MapRendering map(0.05);
    const Pose2 X = test::random_pose(random, 20.0, 3.0);
    map.draw(one_beam(5.0), X);
    const OccupancyGrid grid = map.grid();
    const Vector2 end = X.position() + 5.0 * direction(X.theta);
    const Vector2 tiles = grid.origin / 1.6;
    EXPECT_NEAR(tiles.x(), std::round(tiles.x()), 1e-9);
    EXPECT_NEAR(tiles.y(), std::round(tiles.y()), 1e-9);
    EXPECT_EQ(grid.width % 32, 0);
    EXPECT_EQ(grid.height % 32, 0);
    for (int axis = 0; axis < 2; ++axis) {
      const double low = std::min(X.position()(axis), end(axis));
      const double high = std::max(X.position()(axis), end(axis));
      const double to = grid.origin(axis) + 0.05 * (axis == 0 ? grid.width : grid.height);
      EXPECT_GE(low - grid.origin(axis), 1.6 - 1e-9) << "seed " << seed;
      EXPECT_LT(low - grid.origin(axis), 3.2 + 1e-9) << "seed " << seed;
      EXPECT_GE(to - high, 1.6 - 0.051) << "seed " << seed;
      EXPECT_LT(to - high, 3.2 + 1e-9) << "seed " << seed;
    }
  }
}

// A scanner that is mounted ahead and turned draws from there.
TEST(MapRendering, BeamsStartAtTheScannersMount) {
  RangeImage image = one_beam(1.0);
  image.X_BL = {0.2, 0.0, 0.5 * std::numbers::pi};
  MapRendering map(0.05);
  map.draw(image, {0.025, 0.025, 0.0});
  EXPECT_EQ(value_at(map.grid(), 0.225, 1.03), OccupancyGrid::kOccupied);
  EXPECT_EQ(value_at(map.grid(), 0.225, 0.5), OccupancyGrid::kFree);
  EXPECT_EQ(value_at(map.grid(), 0.125, 0.025), OccupancyGrid::kUnknown);
}

// 400 x 400 m at 5 cm are 64 million cells: 200 m away there is room, 10 km away, at no place and at 1e300 m there is none, and
// the map stays what it was.
TEST(MapRendering, HasABound) {
  MapRendering map(0.05);
  EXPECT_TRUE(map.draw(one_beam(10.0), {}));
  EXPECT_TRUE(map.draw(one_beam(10.0), {200.0, 200.0, 0.0}));
  const OccupancyGrid before = map.grid();
  const std::size_t bytes = map.bytes();
  for (const Pose2& X : {Pose2{10'000.0, 10'000.0, 0.0}, Pose2{-700.0, 600.0, 0.0}, Pose2{NAN, 0.0, 0.0},
                         Pose2{1e300, 0.0, 0.0}})
    EXPECT_FALSE(map.draw(one_beam(10.0), X)) << X.x;
  EXPECT_EQ(map.bytes(), bytes);
  EXPECT_EQ(map.grid().cells, before.cells);
}

}  // namespace
}  // namespace bw::slam
