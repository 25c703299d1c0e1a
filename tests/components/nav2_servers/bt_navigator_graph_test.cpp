// config/graphs/nav2/bt_navigator.yaml as a graph: what is in it, under which names of Nav2's. Nothing is
// run.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "runtime/host/host.hpp"

namespace bw {
namespace {

struct StandIn {
  explicit StandIn(const std::vector<std::string>& set = {})
      : host(load_graph(std::string(BANDWAGON_SOURCE_DIR) + "/config/graphs/nav2/bt_navigator.yaml", set),
             {}) {}

  const ComponentDeclaration& declaration(const std::string& component) const {
    return *std::ranges::find(host.declarations(), component, &ComponentDeclaration::name);
  }
  bool offers(const std::string& component, const std::string& service) const {
    return std::ranges::any_of(declaration(component).services, [&](const ServiceDeclaration& s) {
      return host.graph().find(component)->topic_of(s.name) == service;
    });
  }
  Host host;
};

TEST(BtNavigatorGraph, HasNav2sNames) {
  const StandIn stand_in;
  EXPECT_TRUE(stand_in.offers("bt_navigator", "/navigate_to_pose/_action/send_goal"));
  EXPECT_TRUE(stand_in.offers("bt_navigator", "/navigate_through_poses/_action/send_goal"));
  EXPECT_FALSE(stand_in.offers("bt_navigator", "/follow_waypoints/_action/send_goal"))
      << "Nav2's waypoint_follower has it";
  EXPECT_EQ(stand_in.host.graph().find("nav2_servers")->follows, "bt_navigator");
}

TEST(BtNavigatorGraph, TakesTheWaypointsToo) {
  const StandIn stand_in({"bt_navigator.follow_waypoints=true"});
  EXPECT_TRUE(stand_in.offers("bt_navigator", "/follow_waypoints/_action/send_goal"));
}

TEST(BtNavigatorGraph, IsSoundWithEveryDistribution) {
  for (const std::string distro : {"humble", "jazzy", "kilted", "lyrical"})
    EXPECT_NO_THROW(StandIn({"ros_distro=" + distro})) << distro;
}

}  // namespace
}  // namespace bw
