// config/graphs/nav2/controller_server.yaml as a graph: what is in it, under which names of Nav2's. Nothing
// is run.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "runtime/host/host.hpp"

namespace bw {
namespace {

struct StandIn {
  explicit StandIn(const std::vector<std::string>& set = {})
      : host(
            load_graph(std::string(BANDWAGON_SOURCE_DIR) + "/config/graphs/nav2/controller_server.yaml", set),
            {}) {}
  /// Type of the topic that a component writes, by its full name.
  std::string written(const std::string& component, const std::string& topic) const {
    for (const ComponentDeclaration& declaration : host.declarations()) {
      if (declaration.name != component) continue;
      for (const OutputDeclaration& output : declaration.outputs) {
        if (host.graph().find(component)->topic_of(output.name) == topic) return output.type;
      }
    }
    return "nothing";
  }
  bool offers(const std::string& component, const std::string& service) const {
    for (const ComponentDeclaration& declaration : host.declarations()) {
      if (declaration.name != component) continue;
      return std::ranges::any_of(declaration.services, [&](const ServiceDeclaration& s) {
        return host.graph().find(component)->topic_of(s.name) == service;
      });
    }
    return false;
  }
  Host host;
};

TEST(ControllerServerGraph, HasNav2sNames) {
  const StandIn jazzy;
  EXPECT_EQ(jazzy.written("controller_server", "/cmd_vel_nav"), "geometry_msgs/msg/Twist");
  EXPECT_EQ(jazzy.written("local_costmap", "/local_costmap/costmap"), "nav_msgs/msg/OccupancyGrid");
  EXPECT_EQ(jazzy.written("local_costmap", "/local_costmap/costmap_raw"), "nav2_msgs/msg/Costmap");
  EXPECT_EQ(jazzy.written("local_costmap", "/local_costmap/published_footprint"),
            "geometry_msgs/msg/PolygonStamped");
  EXPECT_EQ(jazzy.written("people", "/tracks"), "bandwagon_msgs/msg/Tracks");
  for (const char* service : {"clear_entirely_local_costmap", "clear_around_local_costmap",
                              "clear_except_local_costmap", "get_costmap", "local_costmap/change_state"})
    EXPECT_TRUE(jazzy.offers("local_costmap", std::string("/local_costmap/") + service)) << service;
  EXPECT_TRUE(jazzy.offers("controller_server", "/controller_server/change_state"));
  EXPECT_EQ(jazzy.host.graph().followers_of("controller_server").size(), 2U);
}

// Humble and Jazzy default to Twist, Kilted and Lyrical to TwistStamped.
TEST(ControllerServerGraph, CommandsAsTheDistributionDoes) {
  const auto command = [](const std::string& distro) {
    return StandIn({"ros_distro=" + distro}).written("controller_server", "/cmd_vel_nav");
  };
  EXPECT_EQ(command("humble"), "geometry_msgs/msg/Twist");
  EXPECT_EQ(command("kilted"), "geometry_msgs/msg/TwistStamped");
  EXPECT_EQ(command("lyrical"), "geometry_msgs/msg/TwistStamped");
  EXPECT_EQ(
      StandIn({"controller_server.enable_stamped_cmd_vel=true"}).written("controller_server", "/cmd_vel_nav"),
      "geometry_msgs/msg/TwistStamped");
}

TEST(ControllerServerGraph, PeopleMayComeFromOthers) {
  const StandIn others({"people.enabled=false", "people_listener.enabled=true"});
  EXPECT_EQ(others.written("people_listener", "/tracks"), "bandwagon_msgs/msg/Tracks");
  EXPECT_EQ(others.written("people", "/tracks"), "nothing");
}

}  // namespace
}  // namespace bw
