#include "components/files/map_file.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "components/files/map_image.hpp"
#include "tests/components/files/map_files.hpp"

namespace bw {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

using namespace std::string_literals;

constexpr std::int8_t kU = OccupancyGrid::kUnknown;

class MapFile : public testing::Test {
 protected:
  OccupancyGrid load(std::string_view yaml) {
    test::write_file(folder_ / "map.yaml", yaml);
    return load_map(folder_ / "map.yaml");
  }
  std::string refusal(std::string_view yaml) {
    try {
      load(yaml);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "accepted";
  }
  OccupancyGrid load_pgm(std::string_view pgm, std::string_view more = "") {
    test::write_file(folder_ / "map.pgm", pgm);
    return load(test::yaml_for("map.pgm", more));
  }
  std::string pgm_refusal(std::string_view pgm) {
    test::write_file(folder_ / "map.pgm", pgm);
    return refusal(test::yaml_for("map.pgm"));
  }
  OccupancyGrid load_png(const test::Png& png, std::string_view more = "") {
    test::write_png(folder_ / "map.png", png);
    return load(test::yaml_for("map.png", more));
  }

  test::TemporaryFolder folder_;
};

// map_server's trinary rule: p = (255 - v) / 255; 89 gives 0.651 (occupied), 90 gives 0.647 (unknown), 205
// gives 0.19608 (unknown), 206 gives 0.192 (free). The top row of the picture is the highest row of cells.
TEST_F(MapFile, ReadsBinaryPgmAsMapServerDoes) {
  const OccupancyGrid grid = load_pgm("P5\n# made by hand\n3 2\n255\n\x00\x59\x5a\xcd\xce\xfe"s);
  EXPECT_EQ(grid.width, 3);
  EXPECT_EQ(grid.height, 2);
  EXPECT_DOUBLE_EQ(grid.resolution, 0.05);
  EXPECT_EQ(grid.origin, Vector2(-1.0, 2.5));
  EXPECT_THAT(grid.cells, ElementsAre(kU, 0, 0, 100, 100, kU));
}

TEST_F(MapFile, ReadsPlainPgm) {
  const OccupancyGrid grid = load_pgm("P2 # plain\n3 2 # size\n100\n0 35 36\n# a comment inside\n80 81 100");
  EXPECT_THAT(grid.cells, ElementsAre(kU, 0, 0, 100, kU, kU));  // p = 1, 0.65, 0.64; 0.2, 0.19, 0
}

// 16-bit pixels are big-endian: 0x0001 of 65535 is black, 0xff00 nearly white.
TEST_F(MapFile, ReadsSixteenBitPgm) {
  const OccupancyGrid grid = load_pgm("P5 3 1 65535\n\x00\x01\xff\x00\x80\x00"s);
  EXPECT_THAT(grid.cells, ElementsAre(100, 0, kU));
}

TEST_F(MapFile, NegatesShades) {
  test::write_file(folder_ / "map.pgm", "P5 3 1 255\n\x00\x80\xff"s);
  std::string yaml = test::yaml_for("map.pgm");
  yaml.replace(yaml.find("negate: 0"), 9, "negate: 1");
  EXPECT_THAT(load(yaml).cells, ElementsAre(0, kU, 100));
}

// The scale is 1 + 98 (p - free) / (occupied - free): v = 205 gives 1 + 98 * 0.0000784 / 0.454 = 1;
// v = 148 gives p = 0.4196 and 1 + 98 * 0.4925 = 49.
TEST_F(MapFile, ScalesBetweenTheThresholds) {
  EXPECT_THAT(load_pgm("P5 4 1 255\n\x00\xcd\x94\xff"s, "mode: scale\n").cells, ElementsAre(100, 1, 49, 0));
}

TEST_F(MapFile, TakesRawValues) {
  EXPECT_THAT(load_pgm("P5 4 1 255\n\x00\x64\x65\xff"s, "mode: raw\n").cells, ElementsAre(0, 100, kU, kU));
}

TEST_F(MapFile, ReadsGrayPngOfEveryDepth) {
  EXPECT_THAT(load_png({3, 2, 8, PNG_COLOR_TYPE_GRAY, "\x00\x59\x5a\xcd\xce\xfe"s}).cells,
              ElementsAre(kU, 0, 0, 100, 100, kU));
  EXPECT_THAT(load_png({3, 1, 16, PNG_COLOR_TYPE_GRAY, "\x00\x01\xff\x00\x80\x00"s}).cells,
              ElementsAre(100, 0, kU));
  EXPECT_THAT(load_png({4, 1, 1, PNG_COLOR_TYPE_GRAY, "\x50"s}).cells,
              ElementsAre(100, 0, 100, 0));  // bits 0101
}

// The shade is the mean of the colours: (255 + 0 + 0) / 3 is 85, p = 0.667 occupied; (255 + 255 + 120) / 3 is
// 210, free.
TEST_F(MapFile, ReadsColouredPng) {
  EXPECT_THAT(load_png({2, 1, 8, PNG_COLOR_TYPE_RGB, "\xff\x00\x00\xff\xff\x78"s}).cells,
              ElementsAre(100, 0));
  EXPECT_THAT(load_png({4,
                        1,
                        2,
                        PNG_COLOR_TYPE_PALETTE,
                        "\x1b"s,
                        {{0, 0, 0}, {255, 255, 255}, {130, 130, 130}, {9, 9, 9}}})
                  .cells,
              ElementsAre(100, 0, kU, 100));
}

TEST_F(MapFile, TreatsTransparentPixelsAsUnknown) {
  EXPECT_THAT(load_png({2, 1, 8, PNG_COLOR_TYPE_GRAY_ALPHA, "\x00\xff\x00\x80"s}).cells,
              ElementsAre(100, kU));
  EXPECT_THAT(load_png({2, 1, 8, PNG_COLOR_TYPE_RGB_ALPHA, "\xff\xff\xff\xff\xff\xff\xff\x00"s}).cells,
              ElementsAre(0, kU));
  EXPECT_THAT(
      load_png({2, 1, 8, PNG_COLOR_TYPE_PALETTE, "\x00\x01"s, {{0, 0, 0}, {255, 255, 255}}, {255, 0}}).cells,
      ElementsAre(100, kU));
}

TEST_F(MapFile, RefusesBadYamlNamingFileLineKeyValueAndRule) {
  test::write_file(folder_ / "map.pgm", "P5 1 1 255\n\x01"s);
  const auto with = [](std::string_view from, std::string_view to) {
    std::string yaml = test::yaml_for("map.pgm");
    return yaml.replace(yaml.find(from), from.size(), to);
  };
  for (const char* bad : {"0", "-1", ".nan", ".inf", "1e-10", "1e10", "wide", "[1]", "1e999"}) {
    const std::string text = refusal(with("resolution: 0.05", "resolution: " + std::string(bad)));
    EXPECT_THAT(text, AllOf(HasSubstr("map.yaml:2: "), HasSubstr("resolution"))) << bad;
  }
  EXPECT_THAT(refusal(with("resolution: 0.05", "resolution: -1")), HasSubstr("resolution = -1: must be"));
  EXPECT_THAT(refusal(with("0.0]", "0.1]")), AllOf(HasSubstr("map.yaml:3: origin.2 = 0.1: must be 0")));
  EXPECT_THAT(refusal(with(", 0.0]", "]")),
              AllOf(HasSubstr("map.yaml:3: origin"), HasSubstr("x, y and yaw")));
  EXPECT_THAT(refusal(with("-1.0", ".nan")), HasSubstr("map.yaml:3: origin.0"));
  EXPECT_THAT(refusal(with("resolution: 0.05\n", "")), HasSubstr("resolution: must be given"));
  EXPECT_THAT(refusal(with("free_thresh: 0.196", "free_thresh: 0.9")),
              HasSubstr("free_thresh must not exceed"));
  EXPECT_THAT(refusal(with("negate: 0", "negate: 2")), HasSubstr("map.yaml:4: negate = 2"));
  EXPECT_THAT(refusal(test::yaml_for("map.pgm", "mode: blurred\n")), HasSubstr("map.yaml:7: mode = blurred"));
  EXPECT_THAT(refusal(test::yaml_for("map.pgm", "modus: raw\n")), HasSubstr("map.yaml:7: modus"));
  EXPECT_THAT(refusal(test::yaml_for("nowhere.pgm")),
              AllOf(HasSubstr("nowhere.pgm: must be a file"), HasSubstr("map.yaml:1: image = nowhere.pgm")));
  EXPECT_THAT(refusal("[1, 2]"), HasSubstr("map.yaml"));
  EXPECT_THAT(refusal(""), HasSubstr("image: must be given"));
  EXPECT_EQ(refusal(with("negate: 0", "negate: false")), "accepted");
}

// Sizes far beyond the file are refused from the header: had they been allocated, these tests would need
// 10^12 bytes.
TEST_F(MapFile, RefusesPicturesThatAreNotWhole) {
  EXPECT_THAT(pgm_refusal("P5 1000000 1000000 255\n"), HasSubstr("must be at most 67108864 cells"));
  EXPECT_THAT(pgm_refusal("P5 999999999 999999999 255\n"), HasSubstr("width x height"));
  EXPECT_THAT(pgm_refusal("P5 8000 8000 255\nshort"), HasSubstr("must have at least 64000000 bytes"));
  EXPECT_THAT(pgm_refusal("P2 8000 8000 255\n1 2 3"), HasSubstr("must have at least 127999999 bytes"));
  EXPECT_THAT(pgm_refusal("P5 2 1 256\n\x01\x01\x01"s), HasSubstr("must have at least 4 bytes"));
  EXPECT_THAT(pgm_refusal("P5 0 10 255\n"), HasSubstr("width = 0: must be at least 1"));
  EXPECT_THAT(pgm_refusal("P5 -3 10 255\n"), HasSubstr("width: must be a number"));
  EXPECT_THAT(pgm_refusal("P5 10000000000 1 255\n"),
              HasSubstr("width: must be a number of at most 9 digits"));
  EXPECT_THAT(pgm_refusal("P5 1 1 0\n\x01"), HasSubstr("maxval = 0"));
  EXPECT_THAT(pgm_refusal("P5 1 1 65536\n\x01\x01"), HasSubstr("maxval = 65536"));
  EXPECT_THAT(pgm_refusal("P5 1 1 100\n\x65"), HasSubstr("pixel 0 = 101: must be at most maxval"));
  EXPECT_THAT(pgm_refusal("P2 2 2 9\n1 2\n3 ten"), AllOf(HasSubstr("map.pgm:3: pixel: must be a number")));
  EXPECT_THAT(pgm_refusal("P5"), HasSubstr("width"));
  EXPECT_THAT(pgm_refusal("P5 # a comment without end"), HasSubstr("width"));
  EXPECT_THAT(pgm_refusal("GIF89a"), HasSubstr("must be a PGM (P2 or P5) or a PNG"));
  EXPECT_THAT(pgm_refusal(""), HasSubstr("must be a PGM"));
}

TEST_F(MapFile, RefusesPngsThatAreNotWhole) {
  test::write_png(folder_ / "map.png", {8, 8, 8, PNG_COLOR_TYPE_GRAY, std::string(64, '\x01')});
  const std::string good = test::read_file(folder_ / "map.png");
  const auto refused = [&](const std::string& bytes) {
    test::write_file(folder_ / "map.png", bytes);
    return refusal(test::yaml_for("map.png"));
  };
  for (std::size_t size = 8; size + 12 < good.size(); ++size) {  // the last chunk (12 bytes) holds nothing
    ASSERT_THAT(refused(good.substr(0, size)), HasSubstr("map.png: ")) << size;
  }
  std::string huge = good;
  huge.replace(16, 8, "\x00\x0f\x42\x40\x00\x0f\x42\x40"s);  // 1e6 x 1e6
  EXPECT_THAT(refused(huge), HasSubstr("must be at most 67108864 cells"));
  huge.replace(16, 8, "\x00\x00\x1f\x40\x00\x00\x1f\x40"s);  // 8000 x 8000 in a file of 70 bytes
  EXPECT_THAT(refused(huge), HasSubstr("must fit the file's length"));
}

TEST_F(MapFile, RefusesFilesThatAreNoFiles) {
  EXPECT_THAT(refusal(test::yaml_for("/dev/zero")), HasSubstr("must be a file"));
  EXPECT_THAT(refusal(test::yaml_for(".")), HasSubstr("must be a file"));
  EXPECT_THROW(load_map(folder_ / "none.yaml"), std::runtime_error);
}

// The sizes of the READMEs of the three recorded maps.
TEST(RecordedMaps, Load) {
  const char* shared = std::getenv("BANDWAGON_SHARED");
  if (shared == nullptr) GTEST_SKIP() << "BANDWAGON_SHARED is not set";
  const std::filesystem::path data = std::filesystem::path(shared) / "data";
  const auto expect = [&](const char* yaml, int width, int height) {
    const OccupancyGrid grid = load_map(data / yaml);
    EXPECT_EQ(grid.width, width);
    EXPECT_EQ(grid.height, height);
  };
  expect("map_warehouse/warehouse.yaml", 1006, 1674);
  expect("map_small_house/small_house.yaml", 375, 222);
  expect("map_tb3_sandbox/tb3_sandbox.yaml", 384, 384);
  const OccupancyGrid sandbox = load_map(data / "map_tb3_sandbox/tb3_sandbox.yaml");
  EXPECT_EQ(sandbox.at(sandbox.column_of(-2.0), sandbox.row_of(-0.5)), OccupancyGrid::kFree);
}

}  // namespace
}  // namespace bw
