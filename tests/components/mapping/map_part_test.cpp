#include "components/mapping/map_part.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "components/mapping/rasterize.hpp"
#include "tests/components/mapping/grids.hpp"

namespace bw {
namespace {

constexpr double kManyCells = 1e6;

/// 4 x 3 cells of 0.5 m from (-1, 2) on, numbered.
OccupancyGrid numbered() {
  OccupancyGrid map = test::empty_grid(4, 3, 0.5, {-1.0, 2.0});
  for (std::size_t i = 0; i < map.cells.size(); ++i) map.cells[i] = static_cast<std::int8_t>(i);
  return map;
}

// From (-0.4, 2.6) to (0.4, 3.4): in columns 1 and 2, rows 1 and 2. They stay where they were.
TEST(MapPart, WithoutATurnIsTheMapsOwnCells) {
  const OccupancyGrid part = part_of(numbered(), {{-0.4, 2.6, 0.0}, 0.8, 0.8}, kManyCells);
  EXPECT_EQ(part.origin, Vector2(-0.5, 2.5));
  EXPECT_EQ(part.width, 2);
  EXPECT_THAT(part.cells, testing::ElementsAre(5, 6, 9, 10));
  const OccupancyGrid all = part_of(numbered(), {{-1.0, 2.0, 0.0}, 2.0, 1.5}, kManyCells);
  EXPECT_EQ(all.cells, numbered().cells);
  EXPECT_EQ(all.origin, numbered().origin);
}

// The lower side goes up along y from (1, 2): the corner is at R(-90) (1, 2) = (2, -1) then, columns go up
// the map, rows to its left; and beyond its left rim nothing is known.
TEST(MapPart, TurnedByARightAngle) {
  const OccupancyGrid part = part_of(numbered(), {{1.0, 2.0, std::numbers::pi / 2.0}, 1.5, 2.5}, kManyCells);
  EXPECT_NEAR((part.origin - Vector2(2.0, -1.0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(part.width, 3);
  EXPECT_EQ(part.height, 5);
  EXPECT_THAT(part.cells, testing::ElementsAre(3, 7, 11, 2, 6, 10, 1, 5, 9, 0, 4, 8, -1, -1, -1));
}

// A wall of one cell from (-3, 0) to (3, 0), drawn under each angle and turned upright: each column of the
// part has it, within a cell of y = 0, and from column to column it moves by one row at most.
TEST(MapPart, AWallStaysWholeUnderAnyAngle) {
  for (double degrees = -90.0; degrees <= 90.0; degrees += 3.0) {
    SCOPED_TRACE(degrees);
    const double theta = degrees * std::numbers::pi / 180.0;
    OccupancyGrid map = test::empty_grid(160, 160, 0.05, {-4.0, -4.0});
    draw_segment(map, {-3.0 * direction(theta), 3.0 * direction(theta)});
    const Vector2 corner = Pose2{0.0, 0.0, theta} * Vector2(-2.0, -1.0);
    const OccupancyGrid part = part_of(map, {{corner.x(), corner.y(), theta}, 4.0, 2.0}, kManyCells);
    EXPECT_NEAR((part.origin - Vector2(-2.0, -1.0)).norm(), 0.0, 1e-9);
    for (int column = 0; column < part.width; ++column) {
      int found = 0;
      for (int row = 0; row < part.height; ++row) {
        if (part.at(column, row) != OccupancyGrid::kOccupied) continue;
        ++found;
        // Half a diagonal of the map's cells and one of the part's.
        EXPECT_LE(std::abs(part.center(column, row).y()), 0.05 * std::numbers::sqrt2 + 1e-9);
      }
      ASSERT_GE(found, 1) << column;
    }
  }
}

TEST(MapPart, WhatIsNoPartIsRefused) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const MapPart& part : {MapPart{{kNan, 0.0, 0.0}, 1.0, 1.0}, MapPart{{0.0, 0.0, kNan}, 1.0, 1.0},
                              MapPart{{}, kNan, 1.0}, MapPart{{}, 0.0, 1.0}, MapPart{{}, 1.0, -1.0},
                              MapPart{{0.0, 0.0, 0.3}, 1e9, 1e9}, MapPart{{1e300, 0.0, 0.0}, 1e300, 1e300}})
    EXPECT_THROW(part_of(numbered(), part, kManyCells), std::runtime_error);
}

}  // namespace
}  // namespace bw
