#include "components/files/map_shades.hpp"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "components/model/occupancy_grid.hpp"

namespace bw {
namespace {

constexpr std::int8_t kU = OccupancyGrid::kUnknown;

std::int8_t read_back(const MapShades& shades, std::int8_t cell) {
  const auto pixel = pixel_of_cell(shades, cell);
  return pixel ? cell_of_shade(shades, *pixel / 255.0) : kU;
}

// map_server's pixels: 254 free, 0 occupied, 205 unknown (p = 50 / 255 = 0.196, at its free_thresh of 0.196).
TEST(MapShades, HaveMapServersPixels) {
  const MapShades shades{.free_thresh = 0.196, .occupied_thresh = 0.65};
  EXPECT_EQ(pixel_of_cell(shades, 0), 254);
  EXPECT_EQ(pixel_of_cell(shades, 100), 0);
  EXPECT_EQ(pixel_of_cell(shades, kU), 205);
}

// With free_thresh 0.25, the default of Nav2's map_saver, 205 is read as free: 0.196 < 0.25. The middle of
// the thresholds is p = 0.45, pixel 255 * 0.55 = 140.25.
TEST(MapShades, KeepUnknownCellsUnknownWithNav2sDefaults) {
  const MapShades shades;
  EXPECT_EQ(cell_of_shade(shades, 205.0 / 255.0), OccupancyGrid::kFree);
  EXPECT_EQ(pixel_of_cell(shades, kU), 140);
  EXPECT_EQ(read_back(shades, kU), kU);
}

// 25 and 65 are the thresholds in cells; map_saver takes both ends in.
TEST(MapShades, TrinaryDividesByTheThresholds) {
  const MapShades shades;
  for (int cell = -1; cell <= 100; ++cell) {
    const int expected = cell < 0 ? kU : cell <= 25 ? 0 : cell >= 65 ? 100 : kU;
    EXPECT_EQ(read_back(shades, static_cast<std::int8_t>(cell)), expected) << cell;
  }
}

// Between the default thresholds lie 0.4 * 255 = 102 pixels for 99 values: none is off by more than one.
TEST(MapShades, ScaleKeepsEveryValueWithinOne) {
  const MapShades shades{.mode = MapMode::scale};
  EXPECT_EQ(read_back(shades, kU), kU);
  EXPECT_EQ(pixel_of_cell(shades, kU), std::nullopt);
  EXPECT_EQ(read_back(shades, 0), 0);
  EXPECT_EQ(read_back(shades, 100), 100);
  EXPECT_EQ(pixel_of_cell(shades, 50), 140);  // p = 0.25 + 0.4 * 49 / 98 = 0.45
  for (int cell = 1; cell <= 99; ++cell)
    EXPECT_NEAR(read_back(shades, static_cast<std::int8_t>(cell)), cell, 1);
}

TEST(MapShades, RawKeepsEveryValue) {
  const MapShades shades{.mode = MapMode::raw};
  for (int cell = -1; cell <= 100; ++cell) EXPECT_EQ(read_back(shades, static_cast<std::int8_t>(cell)), cell);
  EXPECT_EQ(pixel_of_cell(shades, kU), 255);
}

TEST(MapShades, RefuseThresholdsWithoutRoom) {
  EXPECT_EQ(fault_of(MapShades{}), std::nullopt);
  for (const auto& [free, occupied] : {std::pair{0.0, 0.65},
                                       {0.25, 1.0},
                                       {0.65, 0.25},
                                       {0.5, 0.505},
                                       {std::nan(""), 0.65},
                                       {0.25, std::nan("")}}) {
    EXPECT_NE(fault_of(MapShades{.free_thresh = free, .occupied_thresh = occupied}), std::nullopt)
        << free << " " << occupied;
  }
}

}  // namespace
}  // namespace bw
