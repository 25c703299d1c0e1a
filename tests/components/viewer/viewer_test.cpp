// A running viewer, from the socket to the robot and back.
#include <csignal>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <rcl_interfaces/srv/get_parameters.hpp>

#include "runtime/ros/service_call.hpp"
#include "tests/components/viewer/foxglove_client.hpp"
#include "tests/interop/eventually.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

using testing::HasSubstr;

const std::string kRoom = std::string(BANDWAGON_SOURCE_DIR) + "/tests/interop/one_room.yaml";

std::vector<std::string> program(const std::vector<std::string>& words) {
  std::vector<std::string> command = {BANDWAGON_PROGRAM};
  command.insert(command.end(), words.begin(), words.end());
  return command;
}

PageAddress page_of(const Process& server) {
  PageAddress page;
  eventually([&] { return (page = page_in(server.out())).port != 0; });
  return page;
}

/// A robot in a room, which waits for goals.
class Room : public testing::Test {
 protected:
  Process robot_{program({"run", kRoom, "--stay", "--page=0"})};
  PageAddress page_ = page_of(robot_);
};

TEST_F(Room, AParameterSetByTheProtocolIsReadBackByTheService) {
  using rcl_interfaces::srv::GetParameters;
  FoxgloveClient client(page_, false);
  for (const char* service : {"list_parameters", "get_parameters", "set_parameters"})
    ASSERT_TRUE(client.has_service(std::string("/local_planner/") + service));
  const std::string name = "/local_planner.teb.band.min_obstacle_dist";
  EXPECT_EQ(client.set_parameter(name, 0.31)[name], 0.31);
  EXPECT_EQ(client.set_parameter(name, 1)[name], 1.0) << "JSON has one kind of number";
  EXPECT_EQ(client.set_parameter(name, -1)[name], 1.0) << "out of range: what holds is told";
  EXPECT_TRUE(client.hears_status("min_obstacle_dist"));

  dds::Participant other({.network = dds::Network::from_environment(dds::Transport::localhost)});
  GetParameters::Request request;
  request.names({"teb.band.min_obstacle_dist"});
  const auto told =
      call_service<GetParameters>(other, "/local_planner/get_parameters", request, std::chrono::seconds(10));
  ASSERT_TRUE(told.has_value());
  EXPECT_EQ(told->values().at(0).double_value(), 1.0);
}

TEST_F(Room, ServicesAnswer) {
  FoxgloveClient client(page_, false);
  const nlohmann::json state = client.call("/local_planner/get_state", nlohmann::json::object());
  EXPECT_EQ(state["current_state"]["label"], "active") << state;
  EXPECT_THAT(client.call("/local_planner/get_state", {{"nothing", 1}})["error"].get<std::string>(),
              HasSubstr("nothing"));
  EXPECT_TRUE(client.has_service("/navigate_to_pose/_action/send_goal"));
}

TEST_F(Room, EachClientGetsTheMap) {
  FoxgloveClient first(page_, false);
  ASSERT_TRUE(first.subscribe("/map"));
  ASSERT_TRUE(first.wait_for("/map", 1));
  FoxgloveClient second(page_, false);
  ASSERT_TRUE(second.subscribe("/map"));
  ASSERT_TRUE(second.wait_for("/map", 1));
  EXPECT_EQ(first.messages()["/map"][0].cdr, second.messages()["/map"][0].cdr);
}

TEST_F(Room, AClickedGoalIsReached) {
  FoxgloveClient client(page_, false);
  ASSERT_TRUE(client.has_channel("/odom"));
  client.advertise(7, "/goal_pose", "geometry_msgs/PoseStamped");
  client.publish(7, {{"header", {{"frame_id", "map"}, {"stamp", {{"sec", 0}, {"nsec", 5}}}}},
                     {"pose", {{"position", {{"x", 2.0}}}, {"orientation", {{"w", 1}}}}}});
  EXPECT_TRUE(eventually([&] { return robot_.err().find("goal 1: reached in") != std::string::npos; }))
      << robot_.err();
}

TEST_F(Room, WhoComesLaterTakesTheNextFreePort) {
  Process second(program({"view", "--port", std::to_string(page_.port)}));
  EXPECT_GT(page_of(second).port, page_.port);
  second.signal(SIGINT);
  EXPECT_EQ(second.wait(std::chrono::seconds(20)), 0) << second.err();
}

// A server without a robot of its own: as for any ROS 2 system.
TEST(View, ARobotGoesAndComesBack) {
  Process server(program({"view", "--port", "0"}));
  FoxgloveClient client(page_of(server), false);
  auto robot = std::make_unique<Process>(program({"run", kRoom, "--stay"}));
  ASSERT_TRUE(client.subscribe("/odom"));
  ASSERT_TRUE(client.wait_for("/odom", 10));
  const std::uint32_t id = client.channel_id("/odom");
  robot->signal(SIGKILL);  // it says nothing any more: others notice after some seconds
  ASSERT_TRUE(eventually([&] { return client.channel_id("/odom") == 0; }));
  const std::size_t before = client.messages()["/odom"].size();

  robot = std::make_unique<Process>(program({"run", kRoom, "--stay"}));
  ASSERT_TRUE(client.subscribe("/odom"));
  EXPECT_EQ(client.channel_id("/odom"), id);
  EXPECT_TRUE(client.wait_for("/odom", before + 10));
  EXPECT_FALSE(client.is_closed());
}

TEST(View, SaysWhatItCannotShow) {
  const Outcome nobody = run_to_end(program({"view", "no such thing"}), std::chrono::seconds(20));
  EXPECT_EQ(nobody.status, 2);
  EXPECT_THAT(nobody.err, HasSubstr("neither a recording nor an address"));
  const Outcome graph = run_to_end(program({"view", kRoom}), std::chrono::seconds(20));
  EXPECT_EQ(graph.status, 2);
  EXPECT_THAT(graph.err, HasSubstr("bandwagon bag convert"));
  EXPECT_EQ(run_to_end(program({"view", "robot:9000"}), std::chrono::seconds(20)).out,
            "Page: http://robot:9000/\n");
  const Outcome port = run_to_end(program({"run", kRoom, "--page=http"}), std::chrono::seconds(20));
  EXPECT_EQ(port.status, 2);
  EXPECT_THAT(port.err, HasSubstr("--page=http: must be a port"));
  const Outcome open = run_to_end(program({"run", kRoom, "--listen", "0.0.0.0"}), std::chrono::seconds(20));
  EXPECT_NE(open.status, 0);
  EXPECT_THAT(open.err, HasSubstr("token"));
}

}  // namespace
}  // namespace bw::test
