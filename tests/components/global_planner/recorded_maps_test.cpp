// Plans on the maps of real and simulated buildings that lie in $BANDWAGON_SHARED/data.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>

#include <gtest/gtest.h>

#include "components/files/map_file.hpp"
#include "components/global_planner/path_shape.hpp"
#include "components/global_planner/planner.hpp"
#include "components/model/random.hpp"
#include "tests/components/global_planner/random_floor.hpp"

namespace bw {
namespace {

class RecordedMaps : public testing::TestWithParam<const char*> {};

std::uint32_t largest_component(const SearchGrid& grid, const OccupancyGrid& map) {
  std::map<std::uint32_t, int> sizes;
  for (int y = 1; y <= map.height; ++y) {
    for (int x = 1; x <= map.width; ++x) {
      if (grid.free(x, y)) ++sizes[grid.component(x, y)];
    }
  }
  return std::max_element(sizes.begin(), sizes.end(), [](auto& a, auto& b) { return a.second < b.second; })
      ->first;
}

// 200 random pairs in the largest free region (seed 1): every one is answered, the path stays in free cells,
// and no path is shorter than the straight line or longer than the cells of the map could make it.
TEST_P(RecordedMaps, AnswersEveryPairInTheLargestRegion) {
  const char* shared = std::getenv("BANDWAGON_SHARED");
  if (shared == nullptr) GTEST_SKIP() << "BANDWAGON_SHARED is not set";
  const OccupancyGrid map = load_map(std::filesystem::path(shared) / "data" / GetParam());
  Planner planner;
  ASSERT_EQ(planner.set_map(map, Footprint{0.25, {}}), "");
  const SearchGrid& grid = planner.grid();
  const std::uint32_t region = largest_component(grid, map);
  Random random(1);
  const auto pose = [&]() -> Pose2 {
    for (;;) {
      const int x = 1 + static_cast<int>(random.uniform(0, map.width));
      const int y = 1 + static_cast<int>(random.uniform(0, map.height));
      if (!grid.free(x, y) || grid.component(x, y) != region || grid.narrow(x, y) != nullptr) continue;
      const Vector2 p = grid.center(x, y);
      return {p.x(), p.y(), random.uniform(-3.0, 3.0)};
    }
  };
  double longest = 0.0;
  for (int i = 0; i < 200; ++i) {
    const Pose2 start = pose();
    const Pose2 goal = pose();
    const PathResult result = planner.plan(start, goal);
    ASSERT_EQ(result.status, PathStatus::ok) << result.reason;
    EXPECT_EQ(result.path.front().position(), start.position());
    EXPECT_EQ(result.path.back(), goal);
    EXPECT_GE(result.length, (goal.position() - start.position()).norm() - 1e-9);
    for (std::size_t k = 1; k < result.path.size(); ++k) {
      ASSERT_TRUE(line_of_sight(grid, result.path[k - 1].position(), result.path[k].position()).free);
    }
    longest = std::max(longest, result.length);
  }
  std::printf("%s: longest of 200 paths %.1f m\n", GetParam(), longest);
}

INSTANTIATE_TEST_SUITE_P(Data, RecordedMaps,
                         testing::Values("map_warehouse/warehouse.yaml", "map_small_house/small_house.yaml",
                                         "map_tb3_sandbox/tb3_sandbox.yaml"),
                         [](const auto& test) {
                           const std::string yaml = test.param;
                           return yaml.substr(yaml.find('/') + 1, yaml.size() - yaml.find('/') - 6);
                         });

// From the README of the map: a start that is free, to the other side of the nine pillars.
TEST(RecordedMapTb3Sandbox, CrossesTheArena) {
  const char* shared = std::getenv("BANDWAGON_SHARED");
  if (shared == nullptr) GTEST_SKIP() << "BANDWAGON_SHARED is not set";
  Planner planner;
  ASSERT_EQ(planner.set_map(load_map(std::filesystem::path(shared) / "data/map_tb3_sandbox/tb3_sandbox.yaml"),
                            Footprint{0.22, {}}),
            "");
  const PathResult result = planner.plan({-2.0, -0.5, 0.0}, {2.0, 0.5, 0.0});
  ASSERT_EQ(result.status, PathStatus::ok) << result.reason;
  EXPECT_GE(result.length, 4.12);  // straight line
  EXPECT_LE(result.length, 5.5);
}

}  // namespace
}  // namespace bw
