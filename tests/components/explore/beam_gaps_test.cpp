#include "components/explore/beam_gaps.hpp"

#include <gtest/gtest.h>

#include "components/explore/frontier_search.hpp"
#include "tests/components/explore/explore_maps.hpp"

namespace bw::explore {
namespace {

using namespace test;

std::int8_t at(const OccupancyGrid& map, int x, int y) { return map.at(x + 10, y + 10); }

// Free ground of 4 x 3 m, cells of 0.1 m.
TEST(BeamGaps, AreClosedUpToTheirWidthAlongRowsAndColumns) {
  OccupancyGrid map = closed_room();
  fill(map, 5, 0, 8, 30, OccupancyGrid::kUnknown);     // 3 wide, from wall to wall
  fill(map, 15, 0, 19, 30, OccupancyGrid::kUnknown);   // 4 wide
  fill(map, 25, 10, 35, 12, OccupancyGrid::kUnknown);  // 2 high
  const OccupancyGrid closed = without_beam_gaps(map, 0.3);
  EXPECT_EQ(at(closed, 6, 15), OccupancyGrid::kFree);
  EXPECT_EQ(at(closed, 16, 15), OccupancyGrid::kUnknown);
  EXPECT_EQ(at(closed, 30, 11), OccupancyGrid::kFree);
}

TEST(BeamGaps, WhatLiesBesideAWallStaysUnknown) {
  OccupancyGrid map = closed_room();
  fill(map, 37, 0, 40, 30, OccupancyGrid::kUnknown);
  EXPECT_EQ(without_beam_gaps(map, 0.3).cells, map.cells);
}

// Beams 0.2 m apart that have cleared 0.1 m each from x = 1.5 on: what they ended at is the frontier, and not their sides.
TEST(BeamGaps, AreNoFrontiers) {
  OccupancyGrid map = closed_room();
  fill(map, 15, 0, 40, 30, OccupancyGrid::kUnknown);
  for (int y = 0; y < 30; y += 3) fill(map, 15, y, 40, y + 1, OccupancyGrid::kFree);
  fill(map, 15, 29, 40, 30, OccupancyGrid::kFree);
  EXPECT_TRUE(find_frontiers(map, {1.05, 1.45}, {.radius = 0.2}).frontiers.empty());
}

}  // namespace
}  // namespace bw::explore
