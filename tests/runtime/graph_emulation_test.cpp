// What a graph becomes when devices of its robot are emulated.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runtime/graph_files.hpp"

namespace bw {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kGraph = R"(
robot: {base: {driver: kobuki, port: /dev/kobuki}, laser: {driver: none}}
components:
  world:
    process: world+base
    remap: {imu: imu/data}
    parameters: {laser: {noise: 0.02, rate: 10}}
    emulation:
      base: {parameters: {encoder_rate: 100}}
      laser: {remap: {scan: sim/scan}, parameters: {laser: {rate: 50}}}
  base_emulator: {enabled: false, process: world+base, emulation: {base: {enabled: true}}}
  laser: {enabled: false, process: laser, emulation: {laser: {enabled: true}}}
)";

Graph load(const std::vector<std::string>& overrides) {
  const Folder folder;
  return load_graph(folder.write("g.yaml", kGraph), overrides);
}

TEST(Emulation, LeavesTheGraphAloneUnlessAsked) {
  const Graph graph = load({});
  EXPECT_EQ(graph.shared.at("robot").find("base")->find("port")->scalar, "/dev/kobuki");
  EXPECT_FALSE(graph.find("base_emulator")->enabled);
  EXPECT_EQ(graph.find("world")->parameters.find("encoder_rate"), nullptr);
}

TEST(Emulation, ChangesWhatBelongsToDevicesWithACable) {
  const Graph graph = load({"emulate=true"});
  EXPECT_EQ(graph.shared.at("robot").find("base")->find("port")->scalar, "emulator");
  EXPECT_TRUE(graph.find("base_emulator")->enabled);
  EXPECT_EQ(graph.find("world")->parameters.find("encoder_rate")->scalar, "100");
  // The laser of this robot has no driver: its scans come from the world as before.
  EXPECT_EQ(graph.shared.at("robot").find("laser")->find("port"), nullptr);
  EXPECT_FALSE(graph.find("laser")->enabled);
  EXPECT_EQ(graph.find("world")->topic_of("scan"), "/scan");
}

TEST(Emulation, MergesParametersAndRenamesTopics) {
  const Graph graph = load({"emulate=true", "robot.laser.driver=rplidar"});
  EXPECT_TRUE(graph.find("laser")->enabled);
  const ComponentNode& world = *graph.find("world");
  EXPECT_EQ(world.topic_of("scan"), "/sim/scan");
  EXPECT_EQ(world.topic_of("imu"), "/imu/data");
  EXPECT_EQ(world.parameters.find("laser")->find("rate")->scalar, "50");
  EXPECT_EQ(world.parameters.find("laser")->find("noise")->scalar, "0.02");
}

TEST(Emulation, GivesWayToWhatIsSaidOfComponentsWhereverItStands) {
  const Graph graph = load({"base_emulator.enabled=false", "world.encoder_rate=20", "emulate=true"});
  EXPECT_FALSE(graph.find("base_emulator")->enabled);
  EXPECT_EQ(graph.find("world")->parameters.find("encoder_rate")->scalar, "20");
}

TEST(Emulation, IsOfTheRobotThatIsMeantInTheEnd) {
  const Folder folder;
  folder.write("eddie.yaml", "base: {driver: eddie, port: /dev/eddie}\n");
  const Graph graph =
      load_graph(folder.write("g.yaml",
                              "robot: {}\ncomponents: {base_emulator: {enabled: false, emulation: "
                              "{base: {enabled: true}}}}\n"),
                 {"emulate=true", "robot=" + (folder.path() / "eddie.yaml").string()});
  EXPECT_TRUE(graph.find("base_emulator")->enabled);
  EXPECT_EQ(graph.shared.at("robot").find("base")->find("port")->scalar, "emulator");
}

TEST(Emulation, MayBeAskedForByTheGraph) {
  const Folder folder;
  const auto path = folder.write("g.yaml", std::string("emulate: true") + kGraph);
  EXPECT_TRUE(load_graph(path).find("base_emulator")->enabled);
  EXPECT_FALSE(load_graph(path, {"emulate=false"}).find("base_emulator")->enabled);
}

TEST(Emulation, RefusesARobotWithNothingToEmulate) {
  EXPECT_THAT(
      refusal("emulate: true\nrobot: {base: {driver: simulated}}\ncomponents: {a: {}}\n"),
      HasSubstr("g.yaml:1: emulate = true: needs a robot with a device to emulate, as in --set robot=FILE: "
                "robot.base.driver is 'simulated' and robot.laser.driver 'none'"));
}

TEST(Emulation, RefusesWhatItDoesNotKnow) {
  EXPECT_THAT(refusal("components:\n  a: {emulation: {lazer: {enabled: true}}}\n"),
              HasSubstr("g.yaml:2: components.a.emulation.lazer: unknown device; did you mean 'laser'?"));
  EXPECT_THAT(refusal("components:\n  a: {emulation: {base: {enable: true}}}\n"),
              HasSubstr("did you mean 'enabled'?"));
  EXPECT_THAT(refusal("components:\n  a: {emulation: {base: {enabled: 3}}}\n"),
              HasSubstr("components.a.emulation.base.enabled"));
}

}  // namespace
}  // namespace bw
