// A whole robot explores two rooms: emulated Kobuki and laser, SLAM, planners, navigator.
#include "components/lab/bench/explore/explore_drive.hpp"

#include <gtest/gtest.h>

#include "components/lab/bench/explore/coverage.hpp"
#include "tests/components/lab/bench/explore/two_rooms.hpp"

namespace bw {
namespace {

TEST(ExploreDrive, AKobukiMakesTheMapOfTwoRooms) {
  ExploreDriveOptions options;
  options.graph = std::string(BANDWAGON_SOURCE_DIR) + "/config/graphs/map_drive.yaml";
  options.robot = std::string(BANDWAGON_SOURCE_DIR) + "/config/robots/kobuki.yaml";
  options.longest = 120.0;
  const ExploreDrive drive = explore_building(test::two_rooms(), options);
  EXPECT_TRUE(drive.complete) << drive.status;
  EXPECT_EQ(drive.contacts, 0U);
  EXPECT_DOUBLE_EQ(drive.radius, 0.18);
  EXPECT_GT(drive.travel, 2.0);  // the tour of somebody who knows them is longer: exploration_test.cpp
  EXPECT_LT(drive.travel, 15.0);
  ASSERT_TRUE(drive.map);
  EXPECT_GE(coverage(explorable(test::two_rooms(), drive.radius, 0.05), *drive.map), 0.98);
}

}  // namespace
}  // namespace bw
