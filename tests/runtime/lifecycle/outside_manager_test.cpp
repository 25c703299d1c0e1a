// A manager from outside, as Nav2's lifecycle_manager behaves: calls change_state and get_state of each node,
// then opens a bond on /bond and expects the node's beats within half of the timeout (2 s of 4 s). Our own
// manager across processes. And what `ros2 component` asks.
#include <map>
#include <mutex>
#include <thread>

#include <bond/msg/status.hpp>
#include <composition_interfaces/srv/list_nodes.hpp>
#include <composition_interfaces/srv/load_node.hpp>
#include <composition_interfaces/srv/unload_node.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lifecycle_msgs/srv/get_available_states.hpp>
#include <lifecycle_msgs/srv/get_available_transitions.hpp>
#include <lifecycle_msgs/srv/get_state.hpp>
#include <nav2_msgs/srv/manage_lifecycle_nodes.hpp>
#include <rcl_interfaces/msg/log.hpp>
#include <std_srvs/srv/empty.hpp>
#include <std_srvs/srv/trigger.hpp>
#include <unistd.h>

#include "runtime/ros/dds_names.hpp"
#include "runtime/ros/service_call.hpp"
#include "tests/interop/eventually.hpp"
#include "tests/runtime/lifecycle/scripted_graph.hpp"
#include "tests/runtime/scripted.hpp"

namespace bw::test {
namespace {

using BondStatus = bond::msg::Status;
using lifecycle_msgs::srv::GetAvailableStates;
using lifecycle_msgs::srv::GetAvailableTransitions;
using lifecycle_msgs::srv::GetState;
using nav2_msgs::srv::ManageLifecycleNodes;
using std_srvs::srv::Trigger;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr auto kLimit = std::chrono::milliseconds(10'000);

/// A graph, or one process of it, in real time, on a thread of its own until the test ends.
class RunningHost {
 public:
  explicit RunningHost(const Graph& graph, const std::string& only = "")
      : host_(graph, {.clock = ClockMode::wall, .only_process = only}),
        thread_([this] { host_.run(std::nullopt); }) {}
  ~RunningHost() {
    host_.finish({.ok = true, .reason = "the test is over"}, true);
    thread_.join();
  }
  RunningHost(const RunningHost&) = delete;
  RunningHost& operator=(const RunningHost&) = delete;

 private:
  Host host_;
  std::thread thread_;
};

Graph two_servers(bool external) {
  ScriptedGraph g;
  g.add(ComponentNode{.name = "controller_server", .process = "planning"}, [] {
     return Script{};
   }).add(ComponentNode{.name = "planner_server", .process = "rest"}, [] { return Script{}; });
  g.graph.settings.external_lifecycle = external;
  return g.graph;
}

/// The other side, in a participant of its own.
class NavManager {
 public:
  NavManager() {
    bonds_ = participant_.create_reader(end<BondStatus>("/bond", 100), [] {});
    out_ = participant_.create_writer(end<BondStatus>("/bond", 5));
    rosout_ = participant_.create_reader(end<rcl_interfaces::msg::Log>("/rosout", 100), [] {});
  }

  template <class S>
  typename S::Response call(const std::string& service, const typename S::Request& request = {}) {
    const auto response = call_service<S>(participant_, service, request, kLimit);
    EXPECT_TRUE(response) << service << " did not answer";
    return response.value_or(typename S::Response());
  }
  bool change(const std::string& node, std::uint8_t id) {
    ChangeState::Request request;
    request.transition().id(id);
    return call<ChangeState>("/" + node + "/change_state", request).success();
  }
  std::string state(const std::string& node) {
    return call<GetState>("/" + node + "/get_state").current_state().label();
  }
  /// The newest words of the nodes' side by node, since the last look.
  std::map<std::string, BondStatus> look() {
    std::map<std::string, BondStatus> newest;
    dds::Sample sample;
    while (bonds_->take(sample)) {
      BondStatus status;
      EXPECT_TRUE(deserialize(sample.cdr, status));
      if (status.instance_id() != kInstance) newest[status.id()] = status;
    }
    return newest;
  }
  void beat(const std::string& node, bool active) {
    BondStatus status;
    status.id(node);
    status.instance_id(kInstance);
    status.active(active);
    std::vector<std::uint8_t> cdr;
    serialize(status, cdr);
    out_->write(cdr);
  }
  int servers(const std::string& service) const {
    int count = 0;
    for (const dds::Endpoint& end : participant_.endpoints()) {
      if (end.topic == request_topic(service) && !end.is_writer && !end.is_local) ++count;
    }
    return count;
  }
  bool clear() { return call_service<std_srvs::srv::Empty>(participant_, "/clear", {}, kLimit).has_value(); }
  bool was_logged(const std::string& text) {
    dds::Sample sample;
    rcl_interfaces::msg::Log line;
    while (rosout_->take(sample)) {
      if (deserialize(sample.cdr, line) && line.msg().find(text) != std::string::npos) return true;
    }
    return false;
  }

 private:
  static constexpr const char* kInstance = "of-the-manager";

  template <class M>
  static dds::EndpointOptions end(const std::string& topic, int depth) {
    return {.topic = dds_topic(topic),
            .type = std::string(MessageTraits<M>::dds_name),
            .qos = Qos::standard(depth),
            .user_data = {}};
  }

  dds::Participant participant_{{.network = dds::Network::from_environment({})}};
  std::unique_ptr<dds::Reader> bonds_, rosout_;
  std::unique_ptr<dds::Writer> out_;
};

// An empty response looks like success to its caller.
TEST(OutsideManager, ARefusalWithoutAPlaceForItsReasonIsLogged) {
  using std_srvs::srv::Empty;
  Graph graph;
  graph.settings.external_lifecycle = true;
  graph.components.push_back(scripted({.name = "costmap"}, [](bw::Setup& setup) {
    setup.service<Empty>(
        "clear", [](const Empty::Request&, const Tick&) { return Empty::Response(); },
        [](const std::string&) { return Empty::Response(); });
  }));
  const RunningHost running(graph);
  NavManager nav;
  EXPECT_TRUE(eventually([&] {
    return nav.clear() && nav.was_logged("/clear is refused: costmap is not active (unconfigured)");
  }));
}

TEST(OutsideManager, BringsUpBondsAndBringsDown) {
  const RunningHost graph(two_servers(true));
  NavManager nav;
  EXPECT_EQ(nav.state("controller_server"), "unconfigured");
  EXPECT_FALSE(nav.change("planner_server", 3)) << "activate before configure";
  EXPECT_TRUE(nav.look().empty()) << "no bond before activation";
  for (const char* node : {"controller_server", "planner_server"}) {
    EXPECT_TRUE(nav.change(node, 1));
    EXPECT_EQ(nav.state(node), "inactive");
  }
  for (const char* node : {"controller_server", "planner_server"}) EXPECT_TRUE(nav.change(node, 3));

  std::map<std::string, BondStatus> bonds;
  EXPECT_TRUE(eventually([&] {
    for (auto& [node, status] : nav.look()) bonds[node] = status;
    return bonds.size() == 2;
  }));
  const BondStatus controller = bonds["controller_server"];
  EXPECT_TRUE(controller.active());
  EXPECT_FLOAT_EQ(controller.heartbeat_timeout(), 4.0F);
  EXPECT_FLOAT_EQ(controller.heartbeat_period(), 0.1F);
  EXPECT_NE(controller.instance_id(), "");
  EXPECT_NE(controller.instance_id(), bonds["planner_server"].instance_id());

  EXPECT_TRUE(nav.change("controller_server", 4));
  EXPECT_TRUE(eventually([&] {
    const auto said = nav.look();
    const auto last = said.find("controller_server");
    return last != said.end() && !last->second.active();
  })) << "a bond that ends is told";

  // Active once more it is another bond: bondcpp makes one per activation.
  EXPECT_TRUE(nav.change("controller_server", 3));
  EXPECT_TRUE(eventually([&] {
    const auto said = nav.look();
    const auto last = said.find("controller_server");
    return last != said.end() && last->second.active() &&
           last->second.instance_id() != controller.instance_id();
  }));
}

TEST(OutsideManager, WhoFollowsNeedsNoManagerAndHasNoBond) {
  ScriptedGraph g;
  g.add("controller_server", [] { return Script{}; });
  g.add(ComponentNode{.name = "local_costmap", .follows = "controller_server"}, [] { return Script{}; });
  g.graph.settings.external_lifecycle = true;
  const RunningHost graph(g.graph);
  NavManager nav;
  EXPECT_TRUE(nav.change("controller_server", 1));
  EXPECT_EQ(nav.state("local_costmap"), "inactive");
  EXPECT_TRUE(nav.change("controller_server", 3));
  EXPECT_EQ(nav.state("local_costmap"), "active");
  std::map<std::string, BondStatus> bonds;
  int beats = 0;
  EXPECT_TRUE(eventually([&] {
    for (auto& [node, status] : nav.look()) bonds[node] = status, ++beats;
    return beats >= 5;
  }));
  EXPECT_THAT(bonds, ElementsAre(testing::Key("controller_server")));
  EXPECT_TRUE(nav.change("controller_server", 4));
  EXPECT_EQ(nav.state("local_costmap"), "inactive");
}

TEST(OutsideManager, WhoseBeatsEndIsMissedAndNotFollowed) {
  const RunningHost graph(two_servers(true));
  NavManager nav;
  ASSERT_TRUE(nav.change("planner_server", 1));
  ASSERT_TRUE(nav.change("planner_server", 3));
  // A bond is formed by the first word of the other side, and that is its last.
  EXPECT_TRUE(eventually([&] { return nav.look().contains("planner_server"); }));
  nav.beat("planner_server", true);
  EXPECT_TRUE(eventually([&] { return nav.was_logged("planner_server: its manager is gone"); }));
  EXPECT_EQ(nav.state("planner_server"), "active");
}

TEST(OutsideManager, WhoEndsABondIsAnswered) {
  const RunningHost graph(two_servers(true));
  NavManager nav;
  ASSERT_TRUE(nav.change("planner_server", 1));
  ASSERT_TRUE(nav.change("planner_server", 3));
  EXPECT_TRUE(eventually([&] { return nav.look().contains("planner_server"); }));
  nav.beat("planner_server", false);
  EXPECT_TRUE(eventually([&] {
    const auto said = nav.look();
    const auto last = said.find("planner_server");
    return last != said.end() && !last->second.active();
  }));
  EXPECT_EQ(nav.state("planner_server"), "active");
}

TEST(OwnManager, ReachesTheOtherProcesses) {
  const Graph graph = two_servers(false);
  // One after the other: of participants that come into one process at the same time, Fast DDS 2.9 sometimes
  // never tells one of another's endpoints. Processes of their own are not in that danger.
  NavManager nav;
  const RunningHost planning(graph, "planning");
  ASSERT_NE(nav.state("controller_server"), "");
  const RunningHost rest(graph, "rest");
  ASSERT_NE(nav.state("planner_server"), "");
  const auto command = [&nav](std::uint8_t number) {
    ManageLifecycleNodes::Request request;
    request.command(number);
    return nav.call<ManageLifecycleNodes>("/lifecycle_manager_navigation/manage_nodes", request).success();
  };
  const auto is_active = [&nav] { return nav.call<Trigger>("/lifecycle_manager_navigation/is_active"); };
  EXPECT_TRUE(is_active().success());
  EXPECT_TRUE(command(1)) << "pause";
  EXPECT_EQ(nav.state("controller_server"), "inactive");
  EXPECT_EQ(nav.state("planner_server"), "inactive");
  EXPECT_EQ(is_active().message(), "controller_server is inactive");
  EXPECT_TRUE(command(2)) << "resume";
  EXPECT_EQ(nav.state("controller_server"), "active");
  EXPECT_TRUE(is_active().success());
  EXPECT_EQ(nav.servers("/lifecycle_manager_navigation/manage_nodes"), 1);
}

TEST(OutsideTools, SeeStatesTransitionsAndWhatRunsInTheProcess) {
  const RunningHost graph(two_servers(true));
  NavManager nav;
  EXPECT_EQ(nav.call<GetAvailableStates>("/planner_server/get_available_states").available_states().size(),
            11U);
  const auto now =
      nav.call<GetAvailableTransitions>("/planner_server/get_available_transitions").available_transitions();
  ASSERT_EQ(now.size(), 2U);
  EXPECT_EQ(now[0].transition().label(), "configure");
  EXPECT_EQ(now[1].transition().id(), 5);
  EXPECT_EQ(now[1].goal_state().label(), "shuttingdown");
  EXPECT_EQ(nav.call<GetAvailableTransitions>("/planner_server/get_transition_graph")
                .available_transitions()
                .size(),
            25U);

  using namespace composition_interfaces::srv;
  const std::string container = "/bandwagon_" + std::to_string(getpid()) + "/_container/";
  const auto list = nav.call<ListNodes>(container + "list_nodes");
  EXPECT_THAT(list.full_node_names(), ElementsAre("/controller_server", "/planner_server"));
  EXPECT_THAT(list.unique_ids(), ElementsAre(1U, 2U));
  const auto load = nav.call<LoadNode>(container + "load_node");
  EXPECT_FALSE(load.success());
  EXPECT_THAT(load.error_message(), HasSubstr("graph file"));
  const auto unload = nav.call<UnloadNode>(container + "unload_node");
  EXPECT_FALSE(unload.success());
  EXPECT_THAT(unload.error_message(), HasSubstr("stay in it"));
}

}  // namespace
}  // namespace bw::test
