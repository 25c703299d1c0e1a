// The verbs a ROS 2 user types, against a running graph.
#include <algorithm>
#include <fstream>
#include <memory>

#include <gmock/gmock.h>

#include "tests/folder.hpp"
#include "tests/interop/running_graph.hpp"

namespace bw::test {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

class CommandLine : public testing::Test {
 protected:
  static void SetUpTestSuite() { graph_ = std::make_unique<RunningGraph>(); }
  static void TearDownTestSuite() {
    EXPECT_EQ(graph_->stop(), 0) << graph_->process().err();
    graph_.reset();
  }
  static Outcome bandwagon(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), BANDWAGON_PROGRAM);
    return run_to_end(arguments, std::chrono::seconds(60));
  }

  static std::unique_ptr<RunningGraph> graph_;
};

std::unique_ptr<RunningGraph> CommandLine::graph_;

TEST_F(CommandLine, TopicListNamesTopicsAndTypes) {
  const Outcome list = bandwagon({"topic", "list", "-t"});
  EXPECT_EQ(list.status, 0) << list.err;
  for (const char* line : {"/cmd_vel [geometry_msgs/msg/Twist]\n", "/map [nav_msgs/msg/OccupancyGrid]\n",
                           "/odom [nav_msgs/msg/Odometry]\n", "/rosout [rcl_interfaces/msg/Log]\n",
                           "/scan [sensor_msgs/msg/LaserScan]\n", "/tf [tf2_msgs/msg/TFMessage]\n"}) {
    EXPECT_THAT(list.out, HasSubstr(line));
  }
  EXPECT_THAT(list.out, testing::Not(HasSubstr("ros_discovery_info")));
}

TEST_F(CommandLine, TopicInfoNamesNodeQosAndHash) {
  const Outcome info = bandwagon({"topic", "info", "-v", "/odom"});
  EXPECT_EQ(info.status, 0) << info.err;
  for (const char* line :
       {"Type: nav_msgs/msg/Odometry\n", "Publisher count: 1\n", "Node name: /robot_base\n",
        "Endpoint type: PUBLISHER\n", "QoS: RELIABLE VOLATILE\n",
        "RIHS01_3cc97dc7fb7502f8714462c526d369e35b603cfc34d946e3f2eda2766dfec6e0"}) {
    EXPECT_THAT(info.out, HasSubstr(line));
  }
}

TEST_F(CommandLine, HelpListsTopicsAndPrintsOne) {
  const Outcome list = bandwagon({"help"});
  EXPECT_EQ(list.status, 0) << list.err;
  EXPECT_THAT(list.out, HasSubstr("\nComponents:\n"));
  EXPECT_THAT(list.out, ContainsRegex("  ekf +extended Kalman filter"));
  const Outcome page = bandwagon({"help", "ekf/theory"});
  EXPECT_EQ(page.status, 0) << page.err;
  EXPECT_THAT(page.out, testing::StartsWith("# ekf: theory\n"));
  const Outcome nothing = bandwagon({"help", "kalman"});
  EXPECT_EQ(nothing.status, 2);
  EXPECT_THAT(nothing.err, HasSubstr("no topic kalman"));
  EXPECT_THAT(bandwagon({"help", "teb/proof"}).err, HasSubstr("one of these? teb"));
}

// As installed: from any folder, and nothing is written but where it is told.
TEST_F(CommandLine, DemoDrivesFromAnyFolder) {
  const Folder folder;
  const Outcome demo = bandwagon({"demo", "--no-page", "--pace", "0", "--out", (folder / "demo").string()});
  EXPECT_EQ(demo.status, 0) << demo.err;
  EXPECT_THAT(demo.out, HasSubstr("Goal reached in 22.7 s"));  // hallway, seed 7
  for (const char* name : {"score_card.json", "drive.svg", "drive.mcap"})
    EXPECT_TRUE(std::filesystem::exists(folder / "demo" / name)) << name;
  EXPECT_THAT(bandwagon({"graphs"}).out, ContainsRegex("hallway +A robot crosses a hallway"));
  EXPECT_THAT(bandwagon({"robots"}).out, ContainsRegex("kobuki +Kobuki, as below a TurtleBot 2"));
}

TEST_F(CommandLine, TopicInfoOfNothingFails) {
  const Outcome info = bandwagon({"topic", "info", "/nobody"});
  EXPECT_EQ(info.status, 1);
  EXPECT_THAT(info.err, HasSubstr("/nobody"));
}

TEST_F(CommandLine, TopicEchoPrintsYaml) {
  const Outcome echo = bandwagon({"topic", "echo", "--once", "/odom"});
  EXPECT_EQ(echo.status, 0) << echo.err;
  EXPECT_THAT(echo.out, testing::StartsWith("header:\n  stamp:\n    sec: "));
  EXPECT_THAT(echo.out,
              HasSubstr("\n  frame_id: odom\nchild_frame_id: base_link\npose:\n  pose:\n    position:\n"));
  EXPECT_THAT(echo.out, testing::EndsWith("---\n"));
}

TEST_F(CommandLine, TopicEchoPrintsALatchedMap) {
  const Outcome echo = bandwagon({"topic", "echo", "--once", "/map", "--for", "20"});
  EXPECT_EQ(echo.status, 0) << echo.err;
  EXPECT_THAT(echo.out, HasSubstr("  width: 800\n  height: 800\n"));
}

TEST_F(CommandLine, TopicHzMeasures) {
  // The laser's 10 Hz; wide, because a loaded machine may be late.
  const Outcome hz = bandwagon({"topic", "hz", "/scan", "--for", "3"});
  EXPECT_EQ(hz.status, 0) << hz.err;
  EXPECT_THAT(hz.out, ContainsRegex("average rate: ([6-9]|1[0-4])\\."));
  EXPECT_THAT(hz.out, ContainsRegex("min: [0-9.]+s max: [0-9.]+s window: [0-9]+"));
}

TEST_F(CommandLine, NodeListNamesEveryComponent) {
  const Outcome list = bandwagon({"node", "list"});
  EXPECT_EQ(list.status, 0) << list.err;
  EXPECT_EQ(list.out,
            "/bandwagon_" + std::to_string(graph_->process().id()) +
                "\n/lifecycle_manager_navigation\n/map_server\n/motor_control\n/robot_base\n/world\n");
}

// A row of each kind: a cause of the base's, the age of a graph's input, a laser that says nothing.
TEST(Failsafes, AreATableOfWhatStopsTheRobot) {
  const Outcome table = run_to_end({BANDWAGON_PROGRAM, "failsafes", "robot"}, std::chrono::seconds(30));
  ASSERT_EQ(table.status, 0) << table.err;
  for (const char* row :
       {"robot_base +bumper +at once +stop, latched +a bumper touches something; by release_stop\n",
        "local_planner +odom +0.5 s +stop +/odom is silent; by itself, with the next message\n",
        "collision_monitor +laser_silent +0.25 s +stop +scan is silent; by itself"})
    EXPECT_THAT(table.out, testing::ContainsRegex(row));
}

TEST_F(CommandLine, ParamListTellsDefaultsAndWhatTheGraphSets) {
  const Outcome list =
      bandwagon({"param", "list", std::string(BANDWAGON_SOURCE_DIR) + "/config/graphs/hallway.yaml",
                 "navigator", "--set", "navigator.settle_time=2.5"});
  EXPECT_EQ(list.status, 0) << list.err;
  for (const char* line : {"  xy_tolerance (double, m; 0.01 to 5; default 0.2): ",
                           "  settle_time (double, s; 0 to 30; default 1.5, here 2.5): ",
                           "  goal.enabled (bool; any; default false, here true): ",
                           "  goal.x (double, m; -100000 to 100000; default 0.0, here 19.0): "}) {
    EXPECT_THAT(list.out, HasSubstr(line));
  }
}

// Of a whole graph those that people turn first, of the robot too; a component that is named is shown whole.
TEST_F(CommandLine, ParamListBeginsWithWhatPeopleTurnFirst) {
  const std::string graph = std::string(BANDWAGON_SOURCE_DIR) + "/config/graphs/hallway.yaml";
  const Outcome first = bandwagon({"param", "list", graph});
  EXPECT_EQ(first.status, 0) << first.err;
  for (const char* line :
       {"\nrobot:\n", "  limits.v_max (double, m/s; ", "  xy_tolerance (double, m; ", "more: --all"})
    EXPECT_THAT(first.out, HasSubstr(line));
  EXPECT_THAT(first.out, testing::Not(HasSubstr("settle_time")));
  const auto lines = std::ranges::count(first.out, '\n');
  EXPECT_GE(lines, 20);
  EXPECT_LE(lines, 40) << "with the names of components";
  const Outcome all = bandwagon({"param", "list", graph, "--all"});
  EXPECT_THAT(all.out, HasSubstr("settle_time"));
  EXPECT_THAT(all.out, HasSubstr("  wheel_separation (double, m; "));
}

TEST_F(CommandLine, ParamListCountsNames) {
  const std::string nav2 = std::string(BANDWAGON_SOURCE_DIR) + "/config/graphs/nav2/";
  // The robot's file is shared by both and counted once.
  const Outcome count = bandwagon(
      {"param", "list", "--all", "--count", nav2 + "planner_server.yaml", nav2 + "collision_monitor.yaml"});
  EXPECT_EQ(count.status, 0) << count.err;
  EXPECT_EQ(count.out,
            "   26 collision_monitor\n    7 global_costmap\n    6 global_planner\n   22 robot\n   61\n");

  // Of the walls and boxes of a map server 4 and 5, though it has none.
  const Folder folder;
  const std::string area = (folder / "area.yaml").string();
  std::ofstream(area)
      << "components:\n  map_server:\n    parameters:\n      area: {length: 2.0, width: 1.0}\n";
  EXPECT_EQ(bandwagon({"param", "list", "--all", "--count", area}).out, "   17 map_server\n   17\n");

  const Outcome refused = bandwagon({"param", "list", "--all", "--count", nav2 + "map_server.yaml"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("map_server is not counted: "));
}

}  // namespace
}  // namespace bw::test
