// Maps written and read back, and maps that somebody names while the robot drives.
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "components/files/map_file.hpp"
#include "components/model/random.hpp"
#include "tests/components/files/map_files.hpp"

namespace bw {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

using namespace std::string_literals;

constexpr std::int8_t kU = OccupancyGrid::kUnknown;

class MapSaving : public testing::Test {
 protected:
  OccupancyGrid saved(const OccupancyGrid& grid, const MapShades& shades, ImageFormat format) {
    save_map(grid, folder_ / "saved.yaml", shades, format);
    return load_map(folder_ / "saved.yaml");
  }
  std::string refusal(const OccupancyGrid& grid, const std::filesystem::path& yaml,
                      const MapShades& shades = {}) {
    try {
      save_map(grid, yaml, shades);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "written";
  }
  MapReading reading(std::string_view yaml) {
    test::write_file(folder_ / "map.yaml", yaml);
    return try_load_map(folder_ / "map.yaml");
  }
  std::size_t files() {
    const std::filesystem::directory_iterator all(folder_ / "");
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
  }

  test::TemporaryFolder folder_;
};

OccupancyGrid random_map(Random& random, bool has_shares) {
  OccupancyGrid grid{.resolution = random.uniform(0.01, 1.0),
                     .origin = {random.normal(0.0, 30.0), random.normal(0.0, 30.0)},
                     .width = 1 + static_cast<int>(random.uniform(0, 30)),
                     .height = 1 + static_cast<int>(random.uniform(0, 30))};
  for (int i = 0; i < grid.width * grid.height; ++i) {
    const int value = static_cast<int>(random.uniform(-1, 101));
    grid.cells.push_back(static_cast<std::int8_t>(has_shares   ? value
                                                  : value < 30 ? -1
                                                  : value < 60 ? 0
                                                               : 100));
  }
  return grid;
}

TEST_F(MapSaving, GivesBackTheSameGrid) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const bool is_raw = seed % 2 == 0;
    const OccupancyGrid grid = random_map(random, is_raw);
    const OccupancyGrid loaded = saved(grid, {.mode = is_raw ? MapMode::raw : MapMode::trinary},
                                       seed % 4 < 2 ? ImageFormat::pgm : ImageFormat::png);
    EXPECT_EQ(loaded.cells, grid.cells);
    EXPECT_EQ(loaded.width, grid.width);
    EXPECT_EQ(loaded.resolution, grid.resolution);
    EXPECT_EQ(loaded.origin, grid.origin);
  }
  EXPECT_EQ(files(), 3U);  // a YAML, a PGM and a PNG: no drafts
}

TEST_F(MapSaving, ScaleKeepsSharesAndUnknownCellsInAPng) {
  const OccupancyGrid grid{.width = 5, .height = 1, .cells = {0, 50, 100, kU, 20}};
  EXPECT_THAT(saved(grid, {.mode = MapMode::scale}, ImageFormat::png).cells,
              ElementsAre(0, 50, 100, kU, testing::AnyOf(19, 20, 21)));
  EXPECT_THAT(refusal(grid, folder_ / "none.yaml", {.mode = MapMode::scale}), HasSubstr("save a png"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "none.pgm"));
}

// As Nav2's map_saver orders it, and numbers as people write them.
TEST_F(MapSaving, WritesTheYamlOfMapServer) {
  save_map({.resolution = 0.05, .origin = {-1.5, 2.0}, .width = 2, .height = 1, .cells = {0, 100}},
           folder_ / "a \"b\".yaml", {});
  EXPECT_EQ(test::read_file(folder_ / "a \"b\".yaml"),
            "image: \"a \\\"b\\\".pgm\"\nmode: trinary\nresolution: 0.05\norigin: [-1.5, 2, 0]\nnegate: 0\n"
            "occupied_thresh: 0.65\nfree_thresh: 0.25\n");
  EXPECT_EQ(test::read_file(folder_ / "a \"b\".pgm"), "P5\n2 1\n255\n\xfe\0"s);
  EXPECT_THAT(load_map(folder_ / "a \"b\".yaml").cells, ElementsAre(0, 100));
}

TEST_F(MapSaving, SaysWhatCannotBeWrittenAndLeavesNothing) {
  const OccupancyGrid grid{.width = 1, .height = 1, .cells = {0}};
  EXPECT_THAT(refusal(grid, folder_ / "no/such/map.yaml"),
              AllOf(HasSubstr("no/such/map.yaml"), HasSubstr("no folder")));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "no"));
  EXPECT_THAT(refusal(grid, "/proc/self/map.yaml"), HasSubstr("cannot write /proc/self/map.pgm"));
  EXPECT_THAT(refusal(grid, folder_ / "map.yaml", {.free_thresh = 0.7}), HasSubstr("free_thresh"));
  std::filesystem::create_directory(folder_ / "map.pgm");
  EXPECT_THAT(refusal(grid, folder_ / "map.yaml"), HasSubstr("map.pgm"));
  EXPECT_EQ(files(), 1U);  // the folder map.pgm
}

// What LoadMap tells apart. A picture of 30,000 x 30,000 pixels is refused by its header alone.
TEST_F(MapSaving, TellsFaultsApart) {
  EXPECT_EQ(try_load_map(folder_ / "none.yaml").fault, MapFault::no_file);
  EXPECT_EQ(try_load_map(folder_ / "").fault, MapFault::no_file);
  EXPECT_EQ(try_load_map("/dev/zero").fault, MapFault::no_file);
  EXPECT_EQ(reading("}{").fault, MapFault::bad_metadata);
  EXPECT_EQ(reading("image: map.pgm\nresolution: .nan\norigin: [0, 0, 0]\n").fault, MapFault::bad_metadata);
  EXPECT_EQ(reading("image: map.pgm\nresolution: 0.05\norigin: [0, 0, 1]\n").fault, MapFault::bad_metadata);
  EXPECT_EQ(reading(test::yaml_for("none.pgm")).fault, MapFault::bad_data);
  test::write_file(folder_ / "map.pgm", "P5\n30000 30000\n255\n");
  const MapReading huge = reading(test::yaml_for("map.pgm"));
  EXPECT_EQ(huge.fault, MapFault::bad_data);
  EXPECT_THAT(huge.reason, AllOf(HasSubstr("map.pgm"), HasSubstr("30000 x 30000"), HasSubstr("map.yaml")));
  test::write_file(folder_ / "map.pgm", "P5\n2 1\n255\n\xfe"s);
  EXPECT_EQ(reading(test::yaml_for("map.pgm")).fault, MapFault::bad_data);
  test::write_file(folder_ / "map.pgm", "P5\n2 1\n255\n\xfe\0"s);
  const MapReading sound = reading(test::yaml_for("map.pgm"));
  EXPECT_EQ(sound.fault, MapFault::none) << sound.reason;
  EXPECT_THAT(sound.grid.cells, ElementsAre(0, 100));
}

TEST(MapUrl, IsAPathOrAFile) {
  EXPECT_EQ(path_of_url("maps/a.yaml"), "maps/a.yaml");
  EXPECT_EQ(path_of_url("/maps/a%20b.yaml"), "/maps/a%20b.yaml");
  EXPECT_EQ(path_of_url("file:///maps/a%20b.yaml"), "/maps/a b.yaml");
  EXPECT_EQ(path_of_url("file://localhost/a.yaml"), "/a.yaml");
  for (const auto* url : {"", "file://", "file://a.yaml", "file://else/a.yaml", "file:///a%2", "file:///a%zz",
                          "file:///a%00b", "http://host/a.yaml", "package://maps/a.yaml", "a\nb.yaml"}) {
    EXPECT_EQ(path_of_url(url), std::nullopt) << url;
  }
}

}  // namespace
}  // namespace bw
