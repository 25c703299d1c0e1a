#include "components/messages/map_input.hpp"

#include <numeric>

#include <gtest/gtest.h>

namespace bw {
namespace {

/// 4 by 3 cells of 0.
KnownMap map() { return {{0.05, {0.0, 0.0}, 4, 3, std::vector<std::int8_t>(12, 0)}, "map"}; }

map_msgs::msg::OccupancyGridUpdate update(std::int32_t x, std::int32_t y, std::uint32_t width,
                                          std::uint32_t height) {
  map_msgs::msg::OccupancyGridUpdate update;
  update.header().frame_id("map");
  update.x(x);
  update.y(y);
  update.width(width);
  update.height(height);
  update.data().resize(std::size_t{width} * height);
  std::iota(update.data().begin(), update.data().end(), 1);
  return update;
}

TEST(MapInput, AnUpdateIsLaidWhereItIs) {
  KnownMap laid = map();
  EXPECT_TRUE(lay_into(update(1, 1, 2, 2), laid));
  EXPECT_EQ(laid.grid.cells, (std::vector<std::int8_t>{0, 0, 0, 0, 0, 1, 2, 0, 0, 3, 4, 0}));
  EXPECT_TRUE(lay_into(update(0, 0, 4, 3), laid)) << "all of it";
  EXPECT_EQ(laid.grid.cells.back(), 12);
}

// Of another map than the one that is there, or broken: nothing is written.
TEST(MapInput, AnUpdateThatDoesNotFitChangesNothing) {
  KnownMap laid = map();
  for (const auto& [x, y, width, height] :
       {std::array{-1, 0, 2, 2}, {0, -1, 2, 2}, {3, 0, 2, 2}, {0, 2, 2, 2}, {2'000'000'000, 0, 2, 2}})
    EXPECT_FALSE(
        lay_into(update(x, y, static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)), laid))
        << x << ", " << y;
  auto too_short = update(0, 0, 2, 2);
  too_short.data().pop_back();
  EXPECT_FALSE(lay_into(too_short, laid));
  auto huge = update(0, 0, 1, 1);
  huge.width(4'000'000'000U);
  huge.height(4'000'000'000U);
  EXPECT_FALSE(lay_into(huge, laid));
  auto of_another_frame = update(0, 0, 1, 1);
  of_another_frame.header().frame_id("odom");
  EXPECT_FALSE(lay_into(of_another_frame, laid));
  KnownMap none;
  EXPECT_FALSE(lay_into(update(0, 0, 1, 1), none));
  EXPECT_EQ(laid.grid.cells, map().grid.cells);
}

}  // namespace
}  // namespace bw
