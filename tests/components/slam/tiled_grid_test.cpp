#include "components/slam/tiled_grid.hpp"

#include <map>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "components/model/random.hpp"

namespace bw::slam {
namespace {

struct Counted {
  int value = -7;
};

// Against std::map, over steps of a random walk (neighbours) and jumps (tiles far apart, on all sides of
// zero).
TEST(TiledGrid, HoldsWhatWasWrittenAndNothingElse) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const auto between = [&](int low, int high) {
      return low + static_cast<int>(random.bits() % static_cast<std::uint64_t>(high - low + 1));
    };
    TiledGrid<Counted> grid;
    EXPECT_TRUE(grid.empty());
    std::map<std::pair<int, int>, int> written;
    int i = 0;
    int j = 0;
    for (int n = 0; n < 2000; ++n) {
      i += between(-3, 3);
      j += between(-3, 3);
      if (n % 200 == 0) {
        i = between(-700, 700);
        j = between(-700, 700);
      }
      grid.ref(i, j).value = n;
      written[{i, j}] = n;
    }
    for (const auto& [at, value] : written) ASSERT_EQ(grid.at(at.first, at.second).value, value);
    for (int n = 0; n < 2000; ++n) {
      const std::pair at{between(-900, 900), between(-900, 900)};
      const auto found = written.find(at);
      ASSERT_EQ(grid.at(at.first, at.second).value, found == written.end() ? -7 : found->second);
    }
    std::set<std::pair<int, int>> visited;
    std::size_t met = 0;
    grid.for_each([&](int x, int y, const Counted& cell) {
      ASSERT_TRUE(visited.insert({x, y}).second) << "twice: " << x << ", " << y;
      const auto found = written.find({x, y});
      ASSERT_EQ(cell.value, found == written.end() ? -7 : found->second);
      met += found != written.end();
    });
    EXPECT_EQ(met, written.size());
    EXPECT_EQ(visited.size() % (32 * 32), 0U) << "whole tiles";
  }
}

// A map of 100 MB that moves its cells when it grows takes tens of milliseconds for that.
TEST(TiledGrid, CellsStayWhereTheyAre) {
  TiledGrid<Counted> grid;
  const Counted* first = &grid.ref(0, 0);
  for (int n = 1; n < 1000; ++n) grid.ref(40 * n, -40 * n);
  EXPECT_EQ(&grid.ref(0, 0), first);
}

TEST(TiledGrid, CellsBelowZeroAreOfTheTileBelow) {
  TiledGrid<Counted> grid;
  grid.ref(-1, -1).value = 1;
  grid.ref(0, 0).value = 2;
  grid.ref(-32, -32).value = 3;
  grid.ref(-33, -33).value = 4;
  EXPECT_EQ(grid.at(-1, -1).value, 1);
  EXPECT_EQ(grid.at(0, 0).value, 2);
  EXPECT_EQ(grid.at(-32, -32).value, 3);
  EXPECT_EQ(grid.at(-33, -33).value, 4);
  int tiles = 0;
  grid.for_each([&](int i, int j, const Counted&) { tiles += i % 32 == 0 && j % 32 == 0; });
  EXPECT_EQ(tiles, 3) << "-32 to -1 is one tile";
}

// Memory follows what was written: 32 x 32 cells for each of two places 10,000 cells apart, and one number
// for each of the 1 + 313 + 8 times 9 places where tiles could be (four to each side).
TEST(TiledGrid, FarPlacesCostTilesAndNotTheWayBetween) {
  TiledGrid<Counted> grid;
  grid.ref(0, 0).value = 1;
  grid.ref(10000, 0).value = 1;
  int cells = 0;
  grid.for_each([&](int, int, const Counted&) { ++cells; });
  EXPECT_EQ(cells, 2 * 32 * 32);
  EXPECT_LE(grid.bytes(), 2 * 2 * 32 * 32 * sizeof(Counted) + 2 * 322 * 9 * sizeof(std::int32_t));
}

}  // namespace
}  // namespace bw::slam
