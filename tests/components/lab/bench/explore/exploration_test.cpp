// What there is to explore, the tour that knows it, and exploring without errors.
#include <algorithm>

#include <gtest/gtest.h>

#include "components/lab/bench/explore/growing_map.hpp"
#include "components/lab/bench/explore/ideal_exploration.hpp"
#include "tests/components/lab/bench/explore/two_rooms.hpp"

namespace bw {
namespace {

using test::one_room;
using test::two_rooms;

TEST(Explorable, IsWhereTheRobotFits) {
  // The map is that of a laser: cells with a wall are occupied. A disc of 0.2 m keeps its centre 0.25 m from their middles,
  // so that a border of 0.2 m to 0.35 m is left out of 4 m by 3 m.
  const Explorable place = explorable(one_room(), 0.2, 0.1);
  const auto cells = static_cast<double>(std::ranges::count(place.cells, true));
  EXPECT_LE(cells, 36.0 * 26.0);
  EXPECT_GE(cells, 33.0 * 23.0);
}

TEST(Explorable, CoverageIsTheShareThatIsKnownToBeFree) {
  const Explorable place = explorable(one_room(), 0.2, 0.1);
  OccupancyGrid map = place.truth;
  EXPECT_DOUBLE_EQ(coverage(place, map), 1.0);
  // Half of the columns from the left edge on.
  std::size_t left = 0;
  std::size_t all = 0;
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      const bool is_left = column < map.width / 2;
      if (place.cells[map.index(column, row)]) {
        ++all;
        left += is_left ? 1 : 0;
      }
      if (!is_left) map.cells[map.index(column, row)] = OccupancyGrid::kUnknown;
    }
  }
  EXPECT_DOUBLE_EQ(coverage(place, map), static_cast<double>(left) / static_cast<double>(all));
  std::ranges::fill(map.cells, OccupancyGrid::kUnknown);
  EXPECT_DOUBLE_EQ(coverage(place, map), 0.0);
}

TEST(GreedyTour, OfWhatIsSeenFromTheStartHasNoLength) {
  EXPECT_DOUBLE_EQ(greedy_tour(explorable(one_room(), 0.2, 0.1), 12.0), 0.0);
}

TEST(GreedyTour, GoesToTheDoorOfAnotherRoomAndNoFartherThanItsCorners) {
  // All of the second room is seen at the latest from the door's middle, (4, 0.5), 3.3 m as the crow flies, and from 1 m
  // beyond; before the wall's end at (4, 1) comes into line nothing of its upper corner is.
  const double length = greedy_tour(explorable(two_rooms(), 0.2, 0.1), 12.0);
  EXPECT_GT(length, 2.0);
  EXPECT_LT(length, 5.5);
}

TEST(IdealExploration, ClosesTheMapAndIsTheSameTwice) {
  const Explorable place = explorable(two_rooms(), 0.2, 0.1);
  const IdealExplorationOptions options{.radius = 0.2};
  const IdealExploration a = explore_ideally(place, options);
  EXPECT_TRUE(a.complete);
  EXPECT_EQ(a.left, 0U);
  EXPECT_GE(a.known, 0.995);
  EXPECT_GT(a.travel, 2.0);
  EXPECT_LT(a.travel, 12.0);
  const IdealExploration b = explore_ideally(place, options);
  EXPECT_EQ(a.travel, b.travel);
  EXPECT_EQ(a.goals, b.goals);
}

TEST(IdealExploration, OfOneRoomIsOverWithoutAStep) {
  const IdealExploration made = explore_ideally(explorable(one_room(), 0.2, 0.1), {.radius = 0.2});
  EXPECT_TRUE(made.complete);
  EXPECT_EQ(made.goals, 0U);
  EXPECT_DOUBLE_EQ(made.travel, 0.0);
  EXPECT_DOUBLE_EQ(made.known, 1.0);
}

}  // namespace
}  // namespace bw
