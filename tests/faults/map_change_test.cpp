// The hallway while somebody loads maps: broken ones, the hallway once more with other cells and another
// origin, a place that is elsewhere altogether. The robot arrives, and touches nobody.
#include <cmath>
#include <filesystem>

#include <bandwagon_msgs/msg/score_card.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nav2_msgs/srv/load_map.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>

#include "components/files/map_file.hpp"
#include "components/messages/grid.hpp"
#include "tests/components/files/map_files.hpp"
#include "tests/components/service_calls.hpp"

namespace bw {
namespace {

using nav2_msgs::srv::LoadMap;
using testing::ElementsAre;

LoadMap::Request request_for(const std::filesystem::path& file) {
  LoadMap::Request request;
  request.map_url(file.string());
  return request;
}

/// The same walls in cells of 0.1 m, and 2 m more floor all around.
OccupancyGrid coarser(const OccupancyGrid& map) {
  OccupancyGrid coarse{.resolution = 0.1, .origin = map.origin - Vector2(2.0, 2.0)};
  coarse.width = static_cast<int>(std::lround(map.width * map.resolution / 0.1)) + 40;
  coarse.height = static_cast<int>(std::lround(map.height * map.resolution / 0.1)) + 40;
  coarse.cells.assign(static_cast<std::size_t>(coarse.width) * static_cast<std::size_t>(coarse.height),
                      OccupancyGrid::kFree);
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      const Vector2 p = map.center(column, row);
      if (map.at(column, row) > 0)
        coarse.cells[coarse.index(coarse.column_of(p.x()), coarse.row_of(p.y()))] = OccupancyGrid::kOccupied;
    }
  }
  return coarse;
}

TEST(MapChange, TheRobotArrivesWhateverIsLoadedOnTheWay) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "huge.pgm", "P5\n32768 32768\n255\n");  // claims 1 GiB
  test::write_file(folder / "huge.yaml", test::yaml_for("huge.pgm"));
  test::write_file(folder / "nan.yaml", "image: huge.pgm\nresolution: .nan\norigin: [0, 0, 0]\n");
  save_map({.resolution = 0.5, .origin = {500.0, 500.0}, .width = 2, .height = 2, .cells = {0, 0, 0, 100}},
           folder / "elsewhere.yaml", {});
  std::vector<LoadMap::Response> responses;
  std::vector<nav_msgs::msg::OccupancyGrid> maps;
  bandwagon_msgs::msg::ScoreCard card;
  const auto script = [&](bw::Setup& setup) {
    setup.input<nav_msgs::msg::OccupancyGrid>("map", Qos::latched(), [&](const auto& message, const Tick&) {
      maps.push_back(message);
      OccupancyGrid map;
      if (maps.size() == 1 && read_grid(message, map).empty())
        save_map(coarser(map), folder / "coarse.yaml", {});
    });
    setup.input<bandwagon_msgs::msg::ScoreCard>(
        "score_card", Qos::standard(),
        [&card, finish = setup.finish_run()](const auto& message, const Tick&) {
          card = message;
          if (card.finished()) finish(card.reached(), "the goal has ended");
        });
    call_at<LoadMap>(setup, "map_server/load_map",
                     {{4.0, request_for(folder / "none.yaml")},
                      {4.5, request_for(folder / "huge.yaml")},
                      {5.0, request_for(folder / "nan.yaml")},
                      {6.0, request_for(folder / "coarse.yaml")},
                      {9.0, request_for(folder / "elsewhere.yaml")},
                      {10.0, request_for(folder / "coarse.yaml")}},
                     responses);
  };
  std::vector<ExtraComponent> extra;
  extra.push_back({"script", std::make_unique<Script>(script)});
  Host host(load_graph(std::filesystem::path(BANDWAGON_SOURCE_DIR) / "config/graphs/hallway.yaml", {}),
            {.clock = ClockMode::lockstep, .seed = 7}, std::move(extra));
  const RunEnd end = host.run(Duration::seconds(60.0));
  EXPECT_TRUE(end.ok) << end.reason;
  EXPECT_TRUE(card.reached()) << card.reason();
  EXPECT_EQ(card.collisions(), 0U);
  std::vector<int> results;
  for (const auto& response : responses) results.push_back(response.result());
  EXPECT_THAT(results, ElementsAre(1, 2, 3, 0, 0, 0));
  ASSERT_EQ(maps.size(), 4U);
  EXPECT_EQ(maps[1].info().width(), 250U);  // 21 + 4 m
}

}  // namespace
}  // namespace bw
