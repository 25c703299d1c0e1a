// Two graphs with the same text drive alike: what a kept drive is found again by.
#include "components/lab/shards/graph_text.hpp"

#include <gtest/gtest.h>

#include "tests/runtime/graph_files.hpp"

namespace bw {
namespace {

constexpr const char* kGraph = "components:\n  world: {parameters: {map: maps/hall.yaml, rate: 10}}\n";

class GraphText : public testing::Test {
 protected:
  GraphText() {
    folder_.write("maps/hall.yaml", "image: hall.pgm\nresolution: 0.05\n");
    folder_.write("maps/hall.pgm", "P5 2 1 255 ab");
  }
  std::string text(const std::vector<std::string>& overrides = {}) {
    return text_of(load_graph(folder_.write("g.yaml", kGraph), overrides));
  }
  Folder folder_;
};

TEST_F(GraphText, IsTheSameForTheSameGraph) { EXPECT_EQ(text(), text()); }

TEST_F(GraphText, ChangesWithAParameter) { EXPECT_NE(text(), text({"world.rate=11"})); }

TEST_F(GraphText, ChangesWithAMapAndWithItsPicture) {
  const std::string before = text();
  folder_.write("maps/hall.yaml", "image: hall.pgm\nresolution: 0.10\n");
  const std::string other_map = text();
  EXPECT_NE(other_map, before);
  folder_.write("maps/hall.pgm", "P5 2 1 255 ac");
  EXPECT_NE(text(), other_map);
}

TEST_F(GraphText, IsTheSameWhereTheProjectWasMovedTo) {
  folder_.write("moved/maps/hall.yaml", "image: hall.pgm\nresolution: 0.05\n");
  folder_.write("moved/maps/hall.pgm", "P5 2 1 255 ab");
  EXPECT_EQ(text_of(load_graph(folder_.write("moved/g.yaml", kGraph))), text());
}

TEST_F(GraphText, FilesThatNameEachOtherEnd) {
  folder_.write("maps/hall.yaml", "image: hall.yaml\n");
  EXPECT_NE(text(), "");
}

}  // namespace
}  // namespace bw
