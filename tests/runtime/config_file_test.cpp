// Graphs, robots and suites by name: the user's own before those of the tree that this test was built in.
#include "runtime/graph/config_file.hpp"

#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>

#include "runtime/graph/graph.hpp"
#include "tests/folder.hpp"

namespace bw {
namespace {

namespace fs = std::filesystem;

class ConfigFiles : public testing::Test {
 protected:
  ConfigFiles() {
    setenv("XDG_CONFIG_HOME", (user_ / "").c_str(), 1);
    fs::current_path(user_ / "");
  }
  ~ConfigFiles() override { fs::current_path("/"); }

  fs::path write(const std::string& name, const std::string& text) {
    const fs::path path = user_ / name;
    fs::create_directories(path.parent_path());
    std::ofstream(path) << text;
    return path;
  }

  test::Folder user_;
  const fs::path tree_ = fs::path(BANDWAGON_SOURCE_DIR) / "config";
};

std::string refusal_of_name(const std::string& kind, const std::string& name) {
  try {
    config_file(kind, name);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST_F(ConfigFiles, ANameIsFoundFromAnyFolder) {
  EXPECT_EQ(config_file("graphs", "hallway"), tree_ / "graphs/hallway.yaml");
  EXPECT_EQ(config_file("graphs", "nav2/amcl"), tree_ / "graphs/nav2/amcl.yaml");
  EXPECT_EQ(config_file("robots", "kobuki"), tree_ / "robots/kobuki.yaml");
  EXPECT_EQ(config_file("suites", "small_house"), tree_ / "suites/small_house.yaml");
  EXPECT_EQ(load_graph("hallway").path, load_graph(tree_ / "graphs/hallway.yaml").path);
}

TEST_F(ConfigFiles, TheUsersOwnComesFirst) {
  const fs::path own = write("bandwagon/robots/kobuki.yaml", "radius: 0.2\n");
  const fs::path mine = write("bandwagon/robots/mine.yaml", "radius: 0.3\n");
  EXPECT_EQ(config_file("robots", "kobuki"), own);
  EXPECT_EQ(config_file("robots", "mine"), mine);
  std::size_t kobukis = 0;
  for (const ConfigFile& file : config_files("robots")) kobukis += file.name == "kobuki" ? 1 : 0;
  EXPECT_EQ(kobukis, 1U) << "each name once";
}

TEST_F(ConfigFiles, APathIsTakenAsItIs) {
  EXPECT_EQ(config_file("graphs", "nowhere/hallway.yaml"), "nowhere/hallway.yaml");
  EXPECT_EQ(config_file("graphs", "hallway.yaml"), "hallway.yaml");
  fs::create_directories(user_ / "map_drive");
  EXPECT_EQ(config_file("graphs", "map_drive"), tree_ / "graphs/map_drive.yaml") << "a folder is no graph";
  write("hallway", "");
  EXPECT_EQ(config_file("graphs", "hallway"), "hallway") << "there is such a file here";
}

TEST_F(ConfigFiles, AnUnknownNameIsRefusedWithTheNearest) {
  EXPECT_EQ(refusal_of_name("graphs", "hallwy"),
            "command line: graph = hallwy: unknown graph; did you mean 'hallway'?");
  EXPECT_EQ(
      refusal_of_name("robots", "roomba_of_mine"),
      "command line: robot = roomba_of_mine: unknown robot; known: eddie, generic, jackal, kobuki, qbot2e");
}

}  // namespace
}  // namespace bw
