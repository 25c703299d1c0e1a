// Everything that rviz2's Nav2 panel calls or hears is served under its name and type: the lists of
// nav2_rviz_plugins' nav2_panel.cpp and of the lifecycle manager's client, which are the same from Humble to
// Lyrical.
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "runtime/dds/participant.hpp"
#include "tests/interop/eventually.hpp"
#include "tests/interop/running_graph.hpp"

namespace bw::test {
namespace {

struct ExpectedEnd {
  std::string topic;
  std::string type;
  bool is_writer = false;
  Durability durability = Durability::volatile_;
};

void add_service(std::vector<ExpectedEnd>& ends, const std::string& name, const std::string& type) {
  ends.push_back({"rq/" + name + "Request", type + "_Request_"});
  ends.push_back({"rr/" + name + "Reply", type + "_Response_", true});
}

void add_action(std::vector<ExpectedEnd>& ends, const std::string& name, const std::string& type) {
  const std::string parts = name + "/_action/", types = "nav2_msgs::action::dds_::" + type;
  add_service(ends, parts + "send_goal", types + "_SendGoal");
  add_service(ends, parts + "get_result", types + "_GetResult");
  add_service(ends, parts + "cancel_goal", "action_msgs::srv::dds_::CancelGoal");
  ends.push_back({"rt/" + parts + "feedback", types + "_FeedbackMessage_", true});
  ends.push_back({"rt/" + parts + "status", "action_msgs::msg::dds_::GoalStatusArray_", true,
                  Durability::transient_local});
}

std::vector<ExpectedEnd> called_by_the_panel() {
  std::vector<ExpectedEnd> ends;
  add_action(ends, "navigate_to_pose", "NavigateToPose");
  add_action(ends, "navigate_through_poses", "NavigateThroughPoses");
  add_action(ends, "follow_waypoints", "FollowWaypoints");
  for (const std::string manager : {"lifecycle_manager_navigation", "lifecycle_manager_localization"}) {
    add_service(ends, manager + "/manage_nodes", "nav2_msgs::srv::dds_::ManageLifecycleNodes");
    add_service(ends, manager + "/is_active", "std_srvs::srv::dds_::Trigger");
  }
  return ends;
}

TEST(Nav2Panel, EveryNameItUsesIsServed) {
  const RunningGraph graph(std::filesystem::path(BANDWAGON_SOURCE_DIR) / "config/graphs/hallway.yaml");
  dds::Participant observer({.network = dds::Network::from_environment({})});
  const auto find = [&observer](const ExpectedEnd& expected) -> std::optional<dds::Endpoint> {
    for (dds::Endpoint& end : observer.endpoints()) {
      if (!end.is_local && end.topic == expected.topic && end.is_writer == expected.is_writer)
        return std::move(end);
    }
    return std::nullopt;
  };
  const std::vector<ExpectedEnd> all = called_by_the_panel();
  ASSERT_EQ(all.size(), 3U * 8U + 4U * 2U);
  eventually(
      [&] { return std::ranges::all_of(all, [&](const auto& end) { return find(end).has_value(); }); });
  for (const ExpectedEnd& expected : all) {
    const auto end = find(expected);
    ASSERT_TRUE(end) << expected.topic << " is not there";
    EXPECT_EQ(end->type, expected.type) << expected.topic;
    EXPECT_EQ(end->qos.reliability, Reliability::reliable) << expected.topic;
    EXPECT_EQ(end->qos.durability, expected.durability) << expected.topic;
  }
}

}  // namespace
}  // namespace bw::test
