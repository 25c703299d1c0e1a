// Ours and Nav2's server of one name on one domain: the second is not brought up, and who comes later is told
// of.
#include <memory>

#include <gmock/gmock.h>

#include "tests/interop/stand_in.hpp"

namespace bw::test {
namespace {

const plain::ServiceType kPathCheck = {
    .name = "nav2_msgs/srv/IsPathValid", .request_hash = {}, .response_hash = {}};

/// A foreign node that serves is_path_valid.
struct Foreign {
  explicit Foreign(const std::string& name) : node(name), server(node, "/is_path_valid", kPathCheck) {
    node.announce();
  }
  plain::Node node;
  plain::Server server;
};

bool holds(const plain::Bytes& bytes, const std::string& text) {
  return std::search(bytes.begin(), bytes.end(), text.begin(), text.end()) != bytes.end();
}

TEST(DuplicateNames, BesideAServerOfItsNameItIsNotActivated) {
  auto theirs = std::make_unique<Foreign>("planner_server");
  StandIn ours("planner_server");
  Outsider outside;
  ASSERT_TRUE(ours.says("/planner_server is there twice: a node of participant 01.0f."));
  EXPECT_TRUE(ours.says("of this machine has the same name and serves /is_path_valid too"));
  EXPECT_TRUE(outside.change("/planner_server", kConfigure));
  EXPECT_FALSE(outside.change("/planner_server", kActivate));
  EXPECT_EQ(outside.state("/planner_server"), kInactive);
  EXPECT_TRUE(ours.says("activate failed, now inactive: /planner_server is there twice"));
  theirs.reset();
  ASSERT_TRUE(ours.says("/planner_server has no rival any more"));
  EXPECT_TRUE(outside.change("/planner_server", kActivate));
  EXPECT_EQ(outside.state("/planner_server"), kActive);

  // Another server comes while ours is active, under another name.
  auto* rosout = outside.listen("/rosout", "rcl_interfaces/msg/Log");
  auto* diagnostics = outside.listen("/diagnostics", "diagnostic_msgs/msg/DiagnosticArray");
  const std::string sentence =
      "/is_path_valid of /planner_server is served twice: by /other of participant 01.0f.";
  theirs = std::make_unique<Foreign>("other");
  EXPECT_TRUE(Outsider::hears(rosout, [&](const plain::Bytes& bytes) {
    if (!holds(bytes, sentence)) return false;
    plain::CdrIn cdr(bytes);
    cdr.number<std::int32_t>();
    cdr.number<std::uint32_t>();
    EXPECT_EQ(cdr.number<std::uint8_t>(), 40) << "ERROR";
    return true;
  }));
  EXPECT_TRUE(
      Outsider::hears(diagnostics, [&](const plain::Bytes& bytes) { return holds(bytes, sentence); }));
  EXPECT_EQ(outside.state("/planner_server"), kActive) << "a robot that drives is not stopped for it";
  EXPECT_EQ(ours.stop(), 0) << ours.process().err();
}

/// Of all nodes that answer as a component container, what runs in them
/// (composition_interfaces/srv/ListNodes).
std::map<std::string, std::vector<std::string>> containers_seen_by(Outsider& outside) {
  std::map<std::string, std::vector<std::string>> containers;
  for (const plain::NodeInfo& node : outside.node().nodes()) {
    const std::string service = node.name + "/_container/list_nodes";
    if (outside.node().count(plain::request_topic(service), false) == 0) continue;
    const auto reply = outside.call(service, "composition_interfaces/srv/ListNodes");
    if (!reply) continue;
    plain::CdrIn cdr(*reply);
    auto& names = containers[node.name];
    for (auto left = cdr.number<std::uint32_t>(); left > 0; --left) names.push_back(cdr.text());
  }
  return containers;
}

// ROS 2's tools warn of nodes that share a name, and ask one of two. The process id is in the name, so that
// there are none.
TEST(DuplicateNames, SeveralProcessesAreSeveralContainers) {
  StandIn planner("planner_server"), controller("controller_server"), behaviors("behavior_server");
  Outsider outside;
  for (const char* node : {"/planner_server", "/controller_server", "/behavior_server"})
    ASSERT_TRUE(outside.sees_service(std::string(node) + "/get_state", "lifecycle_msgs/srv/GetState"))
        << node;
  const auto name_of = [](StandIn& process) {
    return "/bandwagon_" + std::to_string(process.process().id());
  };
  for (StandIn* process : {&planner, &controller, &behaviors})
    ASSERT_TRUE(outside.sees_node(name_of(*process)));
  std::vector<std::string> names;
  for (const plain::NodeInfo& node : outside.node().nodes()) names.push_back(node.name);
  std::ranges::sort(names);
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end()) << "two nodes of one name";
  const auto containers = containers_seen_by(outside);
  EXPECT_EQ(containers.size(), 3U);
  EXPECT_THAT(containers.at(name_of(planner)), testing::Contains("/planner_server"));
  EXPECT_THAT(containers.at(name_of(controller)), testing::Contains("/controller_server"));
  EXPECT_THAT(containers.at(name_of(behaviors)), testing::Contains("/behavior_server"));
  for (StandIn* process : {&planner, &controller, &behaviors})
    EXPECT_EQ(process->stop(), 0) << process->process().err();
  // Who leaves says so: nobody has to wait for the end of a lease.
  EXPECT_TRUE(eventually([&] {
    return std::ranges::all_of(outside.node().ends(), [](const auto& item) { return item.second.is_own; });
  }));
  EXPECT_EQ(outside.node().expired(), 0);
}

}  // namespace
}  // namespace bw::test
