#include "components/slam/published_map.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "tests/components/slam/slam_scene.hpp"

namespace bw::slam {
namespace {

using News = PublishedMap::News;

MapTile tile(int column, int row, std::int8_t value) {
  MapTile tile;
  tile.column = column;
  tile.row = row;
  tile.cells.fill(value);
  return tile;
}

std::vector<MapTile> tiles_of(MapRendering& rendering) {
  std::vector<MapTile> tiles;
  rendering.gather(rendering.changed_tiles(), tiles);
  return tiles;
}

RangeImage beams_all_round(double metres) {
  RangeImage image;
  image.angle_min = -3.14;
  image.angle_increment = 6.28 / 360.0;
  image.millimetres.assign(360, static_cast<std::uint16_t>(1000.0 * metres));
  return image;
}

// Drawn, moved and taken back at random, gathered now and then in pieces: at the end the published map says
// of each cell what the rendering says, and what lies outside the rendering's grid is unknown.
TEST(PublishedMap, SaysWhatTheRenderingSays) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    MapRendering rendering(0.05);
    PublishedMap map(0.05);
    std::vector<std::pair<RangeImage, Pose2>> drawn;
    std::vector<MapTile> tiles;
    for (int k = 0; k < 40; ++k) {
      drawn.emplace_back(beams_all_round(random.uniform(0.5, 5.0)), test::random_pose(random, 8.0, 3.0));
      rendering.draw(drawn.back().first, drawn.back().second);
      if (k % 3 == 0) {
        rendering.erase(drawn.front().first, drawn.front().second);
        drawn.erase(drawn.begin());
      }
      rendering.gather(10, tiles);
      if (k % 5 == 0) {
        map.next(tiles);
        tiles.clear();
      }
    }
    rendering.gather(rendering.changed_tiles(), tiles);
    map.next(tiles);
    const OccupancyGrid truth = rendering.grid();
    const OccupancyGrid& grid = map.grid();
    int known = 0;
    for (int row = 0; row < grid.height; ++row) {
      for (int column = 0; column < grid.width; ++column) {
        const Vector2 p = grid.center(column, row);
        const int i = truth.column_of(p.x());
        const int j = truth.row_of(p.y());
        const std::int8_t expected = truth.contains(i, j) ? truth.at(i, j) : OccupancyGrid::kUnknown;
        ASSERT_EQ(grid.at(column, row), expected) << p.transpose() << ", seed " << seed;
        known += expected != OccupancyGrid::kUnknown;
      }
    }
    EXPECT_EQ(known, std::count_if(truth.cells.begin(), truth.cells.end(),
                                   [](std::int8_t cell) { return cell != OccupancyGrid::kUnknown; }));
  }
}

// The first scan of a rendering and its grid: a margin of one tile of 32 cells about what was drawn.
TEST(PublishedMap, OfASmallPlaceIsAsLargeAsTheRenderingsGrid) {
  MapRendering rendering(0.05);
  rendering.draw(beams_all_round(4.0), {});
  PublishedMap map(0.05);
  EXPECT_EQ(map.next(tiles_of(rendering)), News::whole);
  const OccupancyGrid grid = rendering.grid();
  EXPECT_EQ(map.grid().cells, grid.cells);
  EXPECT_EQ(map.grid().origin, grid.origin);
  EXPECT_EQ(tiles_of(rendering).size(), 0U);
}

TEST(PublishedMap, TellsWholeMapsAndPartsBetweenThem) {
  PublishedMap map(0.05);
  EXPECT_EQ(map.next({}), News::none);
  const std::vector<MapTile> first = {tile(0, 0, 0), tile(4, 2, 0)};
  EXPECT_EQ(map.next(first), News::whole) << "it has a size now: tiles -1 to 5 and -1 to 3";
  EXPECT_EQ(map.grid().width, 7 * 32);
  EXPECT_EQ(map.grid().height, 5 * 32);
  EXPECT_NEAR(map.grid().origin.x(), -1.6, 1e-12);
  EXPECT_EQ(map.next(first), News::none) << "nothing is new in it";
  EXPECT_EQ(map.next(std::vector{tile(2, 1, 100)}), News::part);
  EXPECT_EQ(map.part().column, 3 * 32);
  EXPECT_EQ(map.part().row, 2 * 32);
  EXPECT_EQ(map.part().width, 32);
  EXPECT_EQ(map.part().height, 32);
  // With what the part before told, since a late joiner has the whole map alone.
  EXPECT_EQ(map.next(std::vector{tile(1, 1, 0)}), News::part);
  EXPECT_EQ(map.part().column, 2 * 32);
  EXPECT_EQ(map.part().width, 2 * 32);
  EXPECT_EQ(map.next({}), News::part) << "told again, to whom it did not reach";
}

// After four intervals with parts a whole one, though nothing changed in the fifth: a late joiner has it all.
TEST(PublishedMap, IsWholeAgainAfterFiveIntervals) {
  PublishedMap map(0.05);
  EXPECT_EQ(map.next(std::vector{tile(0, 0, 0)}), News::whole);
  EXPECT_EQ(map.next(std::vector{tile(0, 0, 100)}), News::part);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(map.next({}), News::part);
  EXPECT_EQ(map.next({}), News::whole);
  for (int k = 0; k < 10; ++k) EXPECT_EQ(map.next({}), News::none);
}

// A corridor of 400 tiles, one more an interval. In steps of a tile it would be resized 399 times; by an eighth
// of its side, once that is more than one, ln(400 / 16) / ln(9 / 8) = 27 times after the first 16.
TEST(PublishedMap, GrowsInLargerStepsTheLargerItIs) {
  PublishedMap map(0.05);
  int resized = 0;
  int width = 0;
  for (int k = 0; k < 400; ++k) {
    map.next(std::vector{tile(k, 0, 0)});
    resized += map.grid().width != width;
    width = map.grid().width;
  }
  EXPECT_GE(width, 32 * 401);
  EXPECT_LE(width, 32 * (401 + 401 / 8));
  EXPECT_LE(resized, 50);
}

// A tile that was taken back outside of what is published makes no map larger.
TEST(PublishedMap, NothingKnownMakesItNoLarger) {
  PublishedMap map(0.05);
  EXPECT_EQ(map.next(std::vector{tile(50, 50, OccupancyGrid::kUnknown)}), News::none);
  EXPECT_EQ(map.grid().width, 0);
}

}  // namespace
}  // namespace bw::slam
