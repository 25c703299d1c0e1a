#include <numbers>

#include <gtest/gtest.h>

#include "components/mapping/costmap/map_fill.hpp"
#include "tests/components/mapping/grids.hpp"

namespace bw::costmap {
namespace {

// Odom lies at (1, 2) in the map, rotated left by 90 degrees: odom (x, y) is map (1 - y, 2 + x).
TEST(MapFill, FillsOnlyWhatNobodyHasSeen) {
  OccupancyGrid map = test::empty_grid(100, 100, 0.05);
  map.cells[map.index(map.column_of(0.525), map.row_of(2.325))] = OccupancyGrid::kOccupied;
  map.cells[map.index(map.column_of(0.725), map.row_of(2.325))] = OccupancyGrid::kOccupied;
  map.cells[map.index(map.column_of(0.925), map.row_of(2.325))] = OccupancyGrid::kUnknown;
  OccupancyGrid local = test::empty_grid(40, 40, 0.05);
  local.cells.assign(local.cells.size(), OccupancyGrid::kUnknown);
  const auto cell = [&](double x, double y) -> std::int8_t& {
    return local.cells[local.index(local.column_of(x), local.row_of(y))];
  };
  cell(0.325, 0.275) = OccupancyGrid::kFree;  // seen free where the map says occupied
  cell(0.525, 0.525) = OccupancyGrid::kOccupied;
  fill_unknown(local, map, {1.0, 2.0, std::numbers::pi / 2.0}, {});
  EXPECT_EQ(cell(0.325, 0.475), OccupancyGrid::kOccupied);
  EXPECT_EQ(cell(0.325, 0.275), OccupancyGrid::kFree);
  EXPECT_EQ(cell(0.325, 0.075), OccupancyGrid::kUnknown);
  EXPECT_EQ(cell(0.525, 0.525), OccupancyGrid::kOccupied);
  EXPECT_EQ(cell(0.725, 0.725), OccupancyGrid::kFree);
  EXPECT_EQ(cell(0.325, 1.525), OccupancyGrid::kUnknown);  // map x = 1 - 1.525: outside
}

}  // namespace
}  // namespace bw::costmap
