// Damaged map files: every one either loads to a grid that makes sense or is refused with a message that
// names a file.
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "components/files/map_file.hpp"
#include "components/files/map_image.hpp"
#include "components/model/random.hpp"
#include "tests/components/files/map_files.hpp"

namespace bw {
namespace {

constexpr std::array<const char*, 24> kTokens = {
    "0",  "-1", ".nan",  ".inf", "1e-10", "1e308", "1000000 1000000", "999999999", "4294967297", "65535",
    "\n", "#",  "[[[[[", "{a: ", "&a",    "*a",    "!!int",           "- ",        "\xff\xfe",   "255",
    "P2", "P5", ":",     "\t"};

std::size_t below(Random& random, std::size_t n) {
  return std::min(static_cast<std::size_t>(random.uniform() * static_cast<double>(n)), n - 1);
}

// One to four of: a byte changed, a bit flipped, a piece cut out or doubled, the end cut off, a token put in.
std::string mutated(Random& random, std::string bytes) {
  const std::size_t changes = 1 + below(random, 4);
  for (std::size_t i = 0; i < changes && !bytes.empty(); ++i) {
    const std::size_t at = below(random, bytes.size());
    const std::size_t length = 1 + below(random, std::min<std::size_t>(bytes.size() - at, 16));
    switch (below(random, 7)) {
      case 0:
        bytes[at] = static_cast<char>(below(random, 256));
        break;
      case 1:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(random, 8)));
        break;
      case 2:
        bytes.erase(at, length);
        break;
      case 3:
        bytes.insert(at, bytes.substr(at, length));
        break;
      case 4:
        bytes.resize(at);
        break;
      case 5:
        bytes.insert(at, kTokens[below(random, kTokens.size())]);
        break;
      default:
        bytes.replace(at, length, kTokens[below(random, kTokens.size())]);
        break;
    }
  }
  return bytes;
}

struct Seed {
  const char* image_name;
  std::string image;
};

std::vector<Seed> seeds(const test::TemporaryFolder& folder) {
  std::string pixels;
  for (int i = 0; i < 12 * 10; ++i) pixels.push_back(static_cast<char>(i % 3 == 0 ? 0 : 254));
  std::string plain = "P2\n# plain\n12 10\n255\n";
  for (const char c : pixels) plain += std::to_string(static_cast<unsigned char>(c)) + " ";
  const auto png = [&](const test::Png& image) {
    test::write_png(folder / "seed.png", image);
    return test::read_file(folder / "seed.png");
  };
  std::string coloured;
  for (const char c : pixels) coloured += std::string(3, c) + '\xff';
  return {{"map.pgm", "P5\n# binary\n12 10\n255\n" + pixels},
          {"map.pgm", plain},
          {"map.pgm", "P5 12 5 65535\n" + pixels},
          {"map.png", png({12, 10, 8, PNG_COLOR_TYPE_GRAY, pixels})},
          {"map.png", png({12, 10, 8, PNG_COLOR_TYPE_RGB_ALPHA, coloured})},
          {"map.png",
           png({12, 10, 8, PNG_COLOR_TYPE_PALETTE, std::string(120, '\x01'), {{0, 0, 0}, {254, 254, 254}}})}};
}

// 3,000 mutants, seeds 1 to 3000; a third of them each: the picture, the YAML, both.
TEST(MapFileMutation, NeverCrashesAndAlwaysSaysWhichFile) {
  const test::TemporaryFolder folder;
  const std::vector<Seed> all = seeds(folder);
  int refused = 0;
  int loaded = 0;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Seed& original = all[seed % all.size()];
    const std::string mode = std::array{"trinary", "scale", "raw"}[below(random, 3)];
    const std::string yaml = test::yaml_for(original.image_name, "mode: " + mode + "\n");
    const std::size_t what = below(random, 3);
    test::write_file(folder / original.image_name,
                     what == 1 ? original.image : mutated(random, original.image));
    test::write_file(folder / "map.yaml", what == 0 ? yaml : mutated(random, yaml));
    try {
      const OccupancyGrid grid = load_map(folder / "map.yaml");
      ++loaded;
      ASSERT_GT(grid.width, 0);
      ASSERT_GT(grid.height, 0);
      ASSERT_LE(grid.cells.size(), kMaxMapCells);
      ASSERT_EQ(grid.cells.size(),
                static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height));
      ASSERT_TRUE(grid.resolution >= 0.001 && grid.resolution <= 100.0);
      ASSERT_TRUE(grid.origin.allFinite());
      for (const std::int8_t cell : grid.cells) ASSERT_TRUE(cell >= -1 && cell <= 100);
    } catch (const std::runtime_error& error) {
      ++refused;
      ASSERT_NE(std::string_view(error.what()).find("map."), std::string_view::npos) << error.what();
    }
  }
  std::printf("3000 mutants: %d refused, %d loaded\n", refused, loaded);
  EXPECT_GT(refused, 1000);
  EXPECT_GT(loaded, 100);
}

}  // namespace
}  // namespace bw
