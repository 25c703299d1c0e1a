// map_server and map_saver on their services, in lock-step.
#include <limits>
#include <numbers>
#include <vector>

#include <bandwagon_msgs/srv/draw_polygon.hpp>
#include <bandwagon_msgs/srv/save_map_part.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nav2_msgs/srv/load_map.hpp>
#include <nav2_msgs/srv/save_map.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <nav_msgs/srv/get_map.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include "components/files/map_file.hpp"
#include "components/messages/grid.hpp"
#include "components/messages/map_input.hpp"
#include "components/messages/obstacles.hpp"
#include "tests/components/files/map_files.hpp"
#include "tests/components/service_calls.hpp"

namespace bw {
namespace {

using bandwagon_msgs::srv::DrawPolygon;
using bandwagon_msgs::srv::SaveMapPart;
using nav2_msgs::srv::LoadMap;
using nav2_msgs::srv::SaveMap;
using nav_msgs::srv::GetMap;
using testing::ElementsAre;

using namespace std::string_literals;

std::string graph(const std::string& saver) {
  return "components: {map_server: {parameters: {area: {length: 2.0, width: 1.0, resolution: 0.5}, walls: [{x1: 0.1, y1: 0.1, "
         "x2: 0.2, y2: 0.1}]}}, map_saver: {parameters: {" +
         saver + "}}}";
}
/// 4 x 2 cells of the graph's area, with its wall.
const OccupancyGrid kArea{.resolution = 0.5, .width = 4, .height = 2, .cells = {100, 0, 0, 0, 0, 0, 0, 0}};

struct Answers {
  std::vector<nav_msgs::msg::OccupancyGrid> maps;  ///< on /map
  std::vector<GetMap::Response> shown;
  std::vector<LoadMap::Response> loaded;
  std::vector<SaveMap::Response> saved;
};

LoadMap::Request load(const std::string& url) {
  LoadMap::Request request;
  request.map_url(url);
  return request;
}

SaveMap::Request save(const std::string& topic, const std::string& url, const std::string& mode = "",
                      const std::string& format = "") {
  SaveMap::Request request;
  request.map_topic(topic);
  request.map_url(url);
  request.map_mode(mode);
  request.image_format(format);
  return request;
}

/// One load or save each tenth of a second, then a look at the map.
Answers run(const std::vector<std::string>& urls, const std::vector<SaveMap::Request>& savings,
            const std::string& saver = "") {
  Answers answers;
  std::vector<TimedRequest<LoadMap>> loads;
  std::vector<TimedRequest<SaveMap>> saves;
  for (const std::string& url : urls)
    loads.push_back({0.1 * static_cast<double>(loads.size() + 1), load(url)});
  for (const auto& request : savings)
    saves.push_back({2.0 + 0.1 * static_cast<double>(saves.size()), request});
  run_with_script(graph(saver), 5.0, [&](bw::Setup& setup) {
    setup.input<nav_msgs::msg::OccupancyGrid>("map", Qos::latched(),
                                              [&](const auto& m, const Tick&) { answers.maps.push_back(m); });
    call_at<GetMap>(setup, "map_server/map", {{0.05}, {4.9}}, answers.shown);
    call_at<LoadMap>(setup, "map_server/load_map", loads, answers.loaded);
    call_at<SaveMap>(setup, "map_saver/save_map", saves, answers.saved);
  });
  return answers;
}

OccupancyGrid grid_of(const nav_msgs::msg::OccupancyGrid& message) {
  OccupancyGrid grid;
  EXPECT_EQ(read_grid(message, grid), "");
  return grid;
}

class MapServices : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
};

TEST_F(MapServices, AnotherMapTakesThePlaceOfTheFirst) {
  const OccupancyGrid other{
      .resolution = 0.1, .origin = {-3.0, 7.0}, .width = 3, .height = 1, .cells = {0, 100, -1}};
  save_map(other, folder_ / "other.yaml", {});
  const Answers answers = run({"file://" + (folder_ / "other.yaml").string()}, {});
  ASSERT_EQ(answers.loaded.size(), 1U);
  EXPECT_EQ(answers.loaded[0].result(), 0);
  ASSERT_EQ(answers.maps.size(), 2U);
  ASSERT_EQ(answers.shown.size(), 2U);
  EXPECT_EQ(grid_of(answers.shown[0].map()).cells, kArea.cells);
  EXPECT_EQ(answers.shown[0].map(), answers.maps[0]);
  for (const auto& message : {answers.loaded[0].map(), answers.maps[1], answers.shown[1].map()}) {
    const OccupancyGrid grid = grid_of(message);
    EXPECT_EQ(grid.cells, other.cells);
    EXPECT_EQ(grid.width, 3);
    EXPECT_EQ(grid.origin, other.origin);
    EXPECT_EQ(grid.resolution, 0.1);
    EXPECT_EQ(message.header().frame_id(), "map");
    EXPECT_NEAR(seconds_since_start(from_stamp(message.info().map_load_time())), 0.1, 1e-6);
  }
}

// nav2_msgs/LoadMap: 1 no file, 2 its picture, 3 its YAML.
TEST_F(MapServices, ABrokenMapIsNamedAndTheFirstOneStays) {
  test::write_file(folder_ / "no_picture.yaml", test::yaml_for("none.pgm"));
  test::write_file(folder_ / "nan.yaml", "image: map.pgm\nresolution: .nan\norigin: [0, 0, 0]\n");
  test::write_file(folder_ / "huge.pgm", "P5\n32768 32768\n255\n");  // claims 1 GiB
  test::write_file(folder_ / "huge.yaml", test::yaml_for("huge.pgm"));
  const auto at = [&](const char* name) { return (folder_ / name).string(); };
  const Answers answers = run({"", "http://host/map.yaml", at("none.yaml"), at(""), "/dev/zero",
                               at("no_picture.yaml"), at("huge.yaml"), at("nan.yaml")},
                              {});
  std::vector<int> results;
  for (const auto& response : answers.loaded) {
    results.push_back(response.result());
    EXPECT_TRUE(response.map().data().empty());
  }
  EXPECT_THAT(results, ElementsAre(1, 1, 1, 1, 1, 2, 2, 3));
  EXPECT_EQ(answers.maps.size(), 1U);
  ASSERT_EQ(answers.shown.size(), 2U);
  EXPECT_EQ(answers.shown[1], answers.shown[0]);
}

TEST_F(MapServices, TheMapIsSavedAndReadBack) {
  const auto at = [&](const char* name) { return (folder_ / name).string(); };
  const Answers answers = run({},
                              {save("", at("a")), save("map", at("b.yaml"), "raw", "png"),
                               save("/map", "file://" + at("c"), "scale")},
                              "folder: " + at(""));
  ASSERT_EQ(answers.saved.size(), 3U);
  for (const auto& response : answers.saved) EXPECT_TRUE(response.result());
  for (const auto* name : {"a.yaml", "b.yaml", "c.yaml"}) {
    const OccupancyGrid grid = load_map(folder_ / name);
    EXPECT_EQ(grid.cells, kArea.cells) << name;
    EXPECT_EQ(grid.resolution, kArea.resolution);
    EXPECT_EQ(grid.origin, kArea.origin);
  }
  for (const auto* name : {"a.pgm", "b.png", "c.png"}) EXPECT_TRUE(std::filesystem::exists(folder_ / name));
}

TEST_F(MapServices, WhatCannotBeSavedIsNot) {
  const auto at = [&](const char* name) { return (folder_ / name).string(); };
  SaveMap::Request crossed = save("map", at("crossed"));
  crossed.free_thresh(0.7F);
  SaveMap::Request nan = save("map", at("nan"));
  nan.occupied_thresh(std::numeric_limits<float>::quiet_NaN());
  const Answers answers = run({},
                              {save("scan", at("topic")), save("map", ""), save("map", at("no/such/folder")),
                               save("map", "/proc/self/map"), save("map", at("mode"), "grey"),
                               save("map", at("format"), "", "bmp"), crossed, nan},
                              "folder: " + at(""));
  ASSERT_EQ(answers.saved.size(), 8U);
  for (std::size_t i = 0; i < answers.saved.size(); ++i) EXPECT_FALSE(answers.saved[i].result()) << i;
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / ""));
}

// Nav2's clients ask for "map" or for an absolute path: within the folder that the graph names, and nowhere
// else; nothing is overwritten.
TEST_F(MapServices, MapsAreSavedBelowTheirFolderAlone) {
  const auto at = [&](const char* name) { return (folder_ / name).string(); };
  std::filesystem::create_directories(folder_ / "maps/floor");
  std::filesystem::create_directory_symlink(folder_ / "", folder_ / "maps/out");
  std::filesystem::create_symlink(folder_ / "victim", folder_ / "maps/link.pgm");
  test::write_file(folder_ / "maps/old.yaml", "old");
  const std::vector<std::pair<std::string, bool>> asked = {{"map", true},          {at("maps/floor/a"), true},
                                                           {"floor/b.yaml", true}, {"map", false},
                                                           {"map.yaml", false},    {"old", false},
                                                           {"link", false},        {"../up", false},
                                                           {"floor/../c", false},  {at("elsewhere"), false},
                                                           {"out/d", false},       {at("maps/../e"), false},
                                                           {at("maps_f"), false},  {"floor/", false},
                                                           {".", false},           {"..", false}};
  std::vector<SaveMap::Request> requests;
  for (const auto& [url, is_saved] : asked) requests.push_back(save("map", url));
  const Answers answers = run({}, requests, "folder: " + at("maps"));
  ASSERT_EQ(answers.saved.size(), asked.size());
  for (std::size_t i = 0; i < asked.size(); ++i)
    EXPECT_EQ(answers.saved[i].result(), asked[i].second) << asked[i].first;
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_ / ""))
    if (entry.is_regular_file()) files.push_back(entry.path().lexically_relative(folder_ / "").string());
  EXPECT_THAT(files, testing::UnorderedElementsAre("maps/map.yaml", "maps/map.pgm", "maps/floor/a.yaml",
                                                   "maps/floor/a.pgm", "maps/floor/b.yaml",
                                                   "maps/floor/b.pgm", "maps/old.yaml"));
}

TEST_F(MapServices, AMapIsOverwrittenWhereThatIsSaid) {
  test::write_file(folder_ / "map.yaml", "old");
  test::write_file(folder_ / "victim", "old");
  std::filesystem::create_symlink(folder_ / "victim", folder_ / "map.pgm");
  const Answers answers =
      run({}, {save("map", "map")}, "overwrite: true, folder: " + (folder_ / "").string());
  ASSERT_EQ(answers.saved.size(), 1U);
  EXPECT_TRUE(answers.saved[0].result());
  EXPECT_EQ(load_map(folder_ / "map.yaml").cells, kArea.cells);
  EXPECT_EQ(std::filesystem::file_size(folder_ / "victim"), 3U);  // the link went, not what it led to
}

DrawPolygon::Request polygon(const std::vector<std::pair<float, float>>& corners, int value,
                             const std::string& frame = "map") {
  DrawPolygon::Request request;
  request.polygon().header().frame_id(frame);
  for (const auto& [x, y] : corners) {
    geometry_msgs::msg::Point32 point;
    point.x(x);
    point.y(y);
    request.polygon().polygon().points().push_back(point);
  }
  request.value(static_cast<std::int8_t>(value));
  return request;
}

/// One request each tenth of a second.
std::pair<std::vector<DrawPolygon::Response>, std::vector<OccupancyGrid>> draw(
    const std::vector<DrawPolygon::Request>& polygons) {
  std::vector<TimedRequest<DrawPolygon>> requests;
  for (const auto& request : polygons)
    requests.push_back({0.1 * static_cast<double>(requests.size() + 1), request});
  std::vector<DrawPolygon::Response> responses;
  std::vector<OccupancyGrid> maps;
  run_with_script(graph(""), 2.0, [&](bw::Setup& setup) {
    setup.input<nav_msgs::msg::OccupancyGrid>(
        "map", Qos::latched(), [&](const auto& m, const Tick&) { maps.push_back(grid_of(m)); });
    call_at<DrawPolygon>(setup, "map_server/draw_polygon", requests, responses);
  });
  return {responses, maps};
}

// Cells of 0.5 m: a rectangle in the two columns from x = 1 on, a point of it erased, then one beyond the
// map, which grows by a column and a row.
TEST_F(MapServices, PolygonsAreDrawnAndErased) {
  const auto [responses, maps] = draw({polygon({{1.1F, 0.1F}, {1.9F, 0.1F}, {1.9F, 0.9F}, {1.1F, 0.9F}}, 100),
                                       polygon({{1.6F, 0.6F}}, 0), polygon({{-0.2F, 1.2F}}, 50)});
  for (const auto& response : responses) EXPECT_TRUE(response.success()) << response.message();
  ASSERT_EQ(maps.size(), 4U);
  EXPECT_EQ(maps[0].cells, kArea.cells);
  EXPECT_THAT(maps[1].cells, ElementsAre(100, 0, 100, 100, 0, 0, 100, 100));
  EXPECT_THAT(maps[2].cells, ElementsAre(100, 0, 100, 100, 0, 0, 100, 0));
  EXPECT_EQ(maps[3].origin, Vector2(-0.5, 0.0));
  EXPECT_THAT(maps[3].cells, ElementsAre(-1, 100, 0, 100, 100, -1, 0, 0, 100, 0, 50, -1, -1, -1, -1));
}

TEST_F(MapServices, WhatIsNoPolygonIsNotDrawn) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto [responses, maps] =
      draw({polygon({{0.1F, 0.1F}}, 100, "odom"), polygon({}, 100), polygon({{nan, 0.1F}}, 100),
            polygon({{0.1F, 0.1F}}, 101), polygon({{0.1F, 0.1F}}, -2), polygon({{1e30F, 1e30F}}, 100),
            polygon({{1e4F, 1e4F}}, 100)});
  ASSERT_EQ(responses.size(), 7U);
  for (const auto& response : responses) {
    EXPECT_FALSE(response.success());
    EXPECT_NE(response.message(), "");
  }
  EXPECT_EQ(maps.size(), 1U);
}

// The lower side goes up along y from (2, 0): two cells of it, and four to its left, turned by a right angle
// about the origin of the map. The wall, in the corner at (0, 0), is at the left end of the top row then.
TEST_F(MapServices, APartIsSavedUpright) {
  SaveMapPart::Request part;
  part.map_url("part");
  part.corner().x(2.0);
  part.corner().theta(std::numbers::pi / 2.0);
  part.length(1.0);
  part.width(2.0);
  SaveMapPart::Request bad = part;
  bad.map_url("bad");
  bad.length(0.0);
  std::vector<SaveMapPart::Response> responses;
  run_with_script(graph("folder: " + (folder_ / "").string()), 2.0, [&](bw::Setup& setup) {
    call_at<SaveMapPart>(setup, "map_saver/save_map_part", {{0.5, part}, {0.6, bad}, {0.7, part}}, responses);
  });
  ASSERT_EQ(responses.size(), 3U);
  EXPECT_TRUE(responses[0].success()) << responses[0].message();
  EXPECT_EQ(responses[1].message(), "length and width of the part must be positive");
  EXPECT_THAT(responses[2].message(), testing::HasSubstr("exists already"));
  const OccupancyGrid saved = load_map(folder_ / "part.yaml");
  EXPECT_EQ(saved.width, 2);
  EXPECT_THAT(saved.cells, ElementsAre(0, 0, 0, 0, 0, 0, 100, 0));
  EXPECT_NEAR((saved.origin - Vector2(0.0, -2.0)).norm(), 0.0, 1e-9);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "bad.pgm"));
}

// A box stands there since the map was told: cell (2, 1), centred at (1.25, 0.75), a metre from the map's wall.
TEST_F(MapServices, WhatAnUpdateChangedIsSavedAndInTheWay) {
  std::vector<SaveMap::Response> saved;
  StaticObstacles seen;
  run_with_script(
      graph("folder: " + (folder_ / "").string() + "}}, obstacles: {parameters: {rate: 10.0"), 2.0,
      [&](bw::Setup& setup) {
        setup.input<bandwagon_msgs::msg::Obstacles>(
            "obstacles", Qos::standard(),
            [&](const auto& m, const Tick&) { seen = to_obstacles(m, Pose2{}); });
        call_at<SaveMap>(setup, "map_saver/save_map", {{1.5, save("", "box")}}, saved);
        setup.every(
            Duration::milliseconds(500), "box",
            [tf = setup.output<tf2_msgs::msg::TFMessage>("/tf_static", Qos::latched()),
             updates = setup.output<map_msgs::msg::OccupancyGridUpdate>("map_updates")](const Tick& tick) {
              tf2_msgs::msg::TFMessage frames;
              frames.transforms().push_back(to_transform("map", "odom", tick.now, {}));
              frames.transforms().push_back(to_transform("odom", "base_link", tick.now, {}));
              if (tick.sequence == 0) return tf.publish(frames);
              map_msgs::msg::OccupancyGridUpdate update;
              update.header(make_header("map", tick.now));
              update.x(2);
              update.y(1);
              update.width(1);
              update.height(1);
              update.data({100});
              updates.publish(update);
            });
      });
  ASSERT_EQ(saved.size(), 1U);
  ASSERT_TRUE(saved[0].result());
  std::vector<std::int8_t> cells = kArea.cells;
  cells[6] = 100;
  EXPECT_EQ(load_map(folder_ / "box.yaml").cells, cells);
  EXPECT_EQ(seen.points.size() + seen.segments.size() + seen.discs.size(), 2U);
}

}  // namespace
}  // namespace bw
