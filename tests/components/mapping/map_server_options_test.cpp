#include "components/mapping/map_server_options.hpp"

#include <gtest/gtest.h>

namespace bw {
namespace {

TEST(MapServerOptions, NeedsAMapOrAnAreaOfBearableSize) {
  EXPECT_TRUE(MapServerOptions{}.violated_rule().has_value());
  EXPECT_FALSE(MapServerOptions{.map = "map.yaml"}.violated_rule().has_value());
  EXPECT_FALSE((MapServerOptions{.area = {.length = 20.0, .width = 6.0}}).violated_rule().has_value());
  EXPECT_TRUE((MapServerOptions{.area = {.length = 1e4, .width = 1e4, .resolution = 0.001}})
                  .violated_rule()
                  .has_value());
}

// 20 x 6 m of 0.05 m: 400 x 120 cells, although 6 / 0.05 is 120.00000000000001 in doubles.
TEST(MapServerOptions, MakesTheHallway) {
  OccupancyGrid grid = area_grid({.x = -1.0, .y = -3.0, .length = 20.0, .width = 6.0});
  EXPECT_EQ(grid.width, 400);
  EXPECT_EQ(grid.height, 120);
  draw_shapes(grid, {{-1.0, 2.99, 19.0, 2.99}}, {});
  for (int column = 0; column < grid.width; ++column)
    EXPECT_EQ(grid.at(column, 119), OccupancyGrid::kOccupied);
  EXPECT_EQ(grid.at(200, 118), OccupancyGrid::kFree);
}

// A box of 2 x 1 m rotated by 45 degrees: its area and outline cells are covered, a corner of its bounding
// box is not.
TEST(MapServerOptions, FillsTurnedBoxes) {
  OccupancyGrid grid = area_grid({.length = 4.0, .width = 4.0, .resolution = 0.05});
  const BoxOptions box{.x = 2.0, .y = 2.0, .length = 2.0, .width = 1.0, .theta = std::numbers::pi / 4.0};
  draw_shapes(grid, {}, {box});
  const Pose2 X_map_box{box.x, box.y, box.theta};
  int occupied = 0;
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      const Vector2 p = inverse(X_map_box) * grid.center(column, row);
      const bool inside = std::abs(p.x()) <= 1.0 && std::abs(p.y()) <= 0.5;
      const bool touched =
          std::abs(p.x()) <= 1.0 + 0.036 && std::abs(p.y()) <= 0.5 + 0.036;  // half a diagonal
      const bool drawn = grid.at(column, row) == OccupancyGrid::kOccupied;
      EXPECT_TRUE(drawn || !inside);
      EXPECT_TRUE(!drawn || touched);
      occupied += drawn ? 1 : 0;
    }
  }
  EXPECT_GT(occupied, 800);  // 2 m^2 / 0.0025 m^2
  EXPECT_LT(occupied, 960);  // and at most the cells the outline of 6 m passes
}

}  // namespace
}  // namespace bw
