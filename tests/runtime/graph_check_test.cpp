// The checks between components, and the picture of a graph.
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/graph/check_graph.hpp"
#include "runtime/graph/dot.hpp"

namespace bw {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr const char* kTwist = "geometry_msgs/msg/Twist";
constexpr const char* kOdometry = "nav_msgs/msg/Odometry";

/// base -> planner -> motor, the smallest closed drive; `more` is appended to the planner's entry.
Graph drive(const std::string& more = "", const std::string& top = "") {
  const auto path = std::filesystem::path(testing::TempDir()) / "drive.yaml";
  std::ofstream(path) << "components:\n  base:\n    process: control\n  planner:\n    process: planning\n"
                      << more << "  motor:\n    process: control\n"
                      << top;
  Graph graph = load_graph(path);
  std::filesystem::remove(path);
  graph.path = "drive.yaml";
  for (ComponentNode& node : graph.components) {
    node.where.file = "drive.yaml";
    for (Remap& remap : node.remaps) remap.where.file = "drive.yaml";
    for (InputSettings& input : node.inputs) input.where.file = "drive.yaml";
  }
  return graph;
}

std::vector<ComponentDeclaration> declarations() {
  return {{"base", {}, {{"odom", kOdometry, Qos::standard()}}},
          {"planner", {{"odom", kOdometry, Qos::sensor()}}, {{"cmd_vel", kTwist, Qos::command(), true}}},
          {"motor", {{"cmd_vel", kTwist, Qos::command()}}, {}}};
}

std::vector<std::string> texts(const std::vector<ComponentDeclaration>& ends, const Graph& graph) {
  std::vector<std::string> lines;
  for (const Violation& violation : check_graph(ends, graph)) lines.push_back(violation.text());
  return lines;
}

TEST(CheckGraph, AcceptsAClosedDrive) { EXPECT_THAT(texts(declarations(), drive()), IsEmpty()); }

TEST(CheckGraph, RefusesTwoTypesOnOneTopic) {
  auto ends = declarations();
  ends[1].inputs[0].type = kTwist;
  EXPECT_THAT(texts(ends, drive()),
              ElementsAre("drive.yaml:4: planner.odom = geometry_msgs/msg/Twist: /odom is "
                          "nav_msgs/msg/Odometry at base (drive.yaml:2)"));
}

TEST(CheckGraph, RefusesQosOfferedBelowRequested) {
  auto ends = declarations();
  ends[0].outputs[0].qos = Qos::sensor();
  ends[1].inputs[0].qos = Qos::latched();
  EXPECT_THAT(
      texts(ends, drive()),
      ElementsAre(
          "drive.yaml:4: planner.odom = reliable: /odom is only best effort at base (drive.yaml:2)",
          "drive.yaml:4: planner.odom = transient local: /odom is only volatile at base (drive.yaml:2)"));
}

TEST(CheckGraph, RefusesASecondPublisherOfACommand) {
  auto ends = declarations();
  ends[0].outputs.push_back({"cmd_vel", kTwist, Qos::standard()});
  EXPECT_THAT(texts(ends, drive()),
              ElementsAre("drive.yaml:2: base.cmd_vel: /cmd_vel is a command and has a publisher "
                          "already: planner (drive.yaml:4)"));
}

TEST(CheckGraph, RefusesAnInputLeftToOthersThatHearsItsOwnCommandBack) {
  auto ends = declarations();
  ends[1].inputs.push_back({"cmd_vel_hand", kTwist, Qos::command()});
  ends[2].outputs.push_back({"cmd_vel_safe", kTwist, Qos::command(), true});
  const std::string back = "    remap: {cmd_vel_hand: cmd_vel_safe}\n";
  const std::string open = back + "    inputs: {cmd_vel_hand: {external: true}}\n";
  EXPECT_THAT(texts(ends, drive(open)),
              ElementsAre("drive.yaml:7: planner.cmd_vel_hand = /cmd_vel_safe: is left to others and hears "
                          "its own command back: planner -> motor -> planner; remap it"));
  EXPECT_THAT(texts(ends, drive(back)), IsEmpty());  // it wants to see what became of it
  ends[1].inputs[1].only_newest = true;
  EXPECT_THAT(texts(ends, drive(open)), IsEmpty());
}

TEST(CheckGraph, RefusesAnInputThatNobodyFeeds) {
  auto ends = declarations();
  ends[2].inputs[0].name = "cmd_vel_safe";
  EXPECT_THAT(
      texts(ends, drive()),
      ElementsAre("drive.yaml:6: motor.cmd_vel_safe: nobody publishes /cmd_vel_safe; remap it, or mark the "
                  "input external: true"));
  ends[2].inputs[0].name = "cmd_vle";
  EXPECT_THAT(texts(ends, drive()),
              ElementsAre("drive.yaml:6: motor.cmd_vle: nobody publishes /cmd_vle; remap it, or "
                          "mark the input external: true; did you mean /cmd_vel?"));
  EXPECT_THAT(texts(ends, drive("", "    inputs: {cmd_vle: {external: true}}\n")), IsEmpty());
  EXPECT_THAT(texts(ends, drive("", "    remap: {cmd_vle: cmd_vel}\n")), IsEmpty());
  ends[2].inputs[0].optional = true;
  EXPECT_THAT(texts(ends, drive()), IsEmpty());
}

TEST(CheckGraph, RefusesRemapsAndInputsOfNamesThatAreNotThere) {
  EXPECT_THAT(texts(declarations(), drive("    remap:\n      odm: odom\n")),
              ElementsAre("drive.yaml:7: components.planner.remap.odm: unknown name; did you mean 'odom'?"));
  EXPECT_THAT(texts(declarations(), drive("    inputs:\n      cmd_vel: {max_age: 1s}\n")),
              ElementsAre("drive.yaml:7: components.planner.inputs.cmd_vel: unknown input; known: odom"));
}

TEST(CheckGraph, RefusesBadNamesAndUnknownComponents) {
  auto ends = declarations();
  ends[0].outputs.push_back({"my-topic", kTwist, Qos::standard()});
  ends.push_back({"ghost", {}, {}});
  EXPECT_THAT(
      texts(ends, drive()),
      ElementsAre(
          "drive.yaml:2: base.my-topic = /my-topic: must be a topic name: letters, digits and _ between "
          "single /, no digit after a /",
          "drive.yaml: ghost: is not a component of this graph"));
}

TEST(CheckGraph, KeepsRobotsApartByNamespace) {
  auto ends = declarations();
  EXPECT_THAT(
      texts(ends, drive("    namespace: robot2\n")),
      ElementsAre(
          "drive.yaml:7: motor.cmd_vel: nobody publishes /cmd_vel; remap it, or mark the input external: "
          "true",
          "drive.yaml:4: planner.odom: nobody publishes /robot2/odom; remap it, or mark the input "
          "external: true"));
}

TEST(ToDot, DrawsProcessesAndTopics) {
  auto ends = declarations();
  ends[1].inputs.push_back({"goal_pose", "geometry_msgs/msg/PoseStamped", Qos::standard(), true});
  EXPECT_EQ(to_dot(ends, drive()), R"(digraph "drive" {
  rankdir=LR;
  node [shape=box];
  subgraph cluster_0 {
    label="control";
    "/base";
    "/motor";
  }
  subgraph cluster_1 {
    label="planning";
    "/planner";
  }
  outside [shape=ellipse];
  "/base" -> "/planner" [label="/odom\nnav_msgs/msg/Odometry", style=dashed];
  outside -> "/planner" [label="/goal_pose\ngeometry_msgs/msg/PoseStamped"];
  "/planner" -> "/motor" [label="/cmd_vel\ngeometry_msgs/msg/Twist"];
}
)");
}

}  // namespace
}  // namespace bw
