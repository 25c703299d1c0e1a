// Every op and opcode that the server sends, as the documents of the protocol have them; bytes are written
// down by hand.
#include "runtime/remote/foxglove/server_ops.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace bw::foxglove {
namespace {

void expect_json(const std::string& op, const char* expected) {
  EXPECT_EQ(nlohmann::json::parse(op), nlohmann::json::parse(expected)) << op;
}

TEST(ServerText, ServerInfo) {
  expect_json(server_info_op({"Bandwagon", {"time", "clientPublish"}, {{"ROS_DISTRO", "jazzy"}}, "7"}), R"({
    "op": "serverInfo", "name": "Bandwagon", "capabilities": ["time", "clientPublish"], "supportedEncodings": ["cdr", "json"],
    "metadata": {"ROS_DISTRO": "jazzy"}, "sessionId": "7"})");
  expect_json(server_info_op({}),
              R"({"op": "serverInfo", "name": "", "capabilities": [], "supportedEncodings": ["cdr", "json"],
    "metadata": {}})");
}

TEST(ServerText, Statuses) {
  expect_json(status_op(Level::warning, "slow", "a"),
              R"({"op": "status", "level": 1, "message": "slow", "id": "a"})");
  expect_json(status_op(Level::error, "bad"), R"({"op": "status", "level": 2, "message": "bad"})");
  expect_json(remove_status_op({"a", "b"}), R"({"op": "removeStatus", "statusIds": ["a", "b"]})");
}

TEST(ServerText, Channels) {
  const std::vector<Channel> channels = {{1, "/odom", "nav_msgs/msg/Odometry", "Header header\n", false},
                                         {2, "/map", "nav_msgs/msg/OccupancyGrid", "", true}};
  expect_json(advertise_op(channels), R"({"op": "advertise", "channels": [
    {"id": 1, "topic": "/odom", "encoding": "cdr", "schemaName": "nav_msgs/msg/Odometry", "schemaEncoding": "ros2msg",
     "schema": "Header header\n"},
    {"id": 2, "topic": "/map", "encoding": "cdr", "schemaName": "nav_msgs/msg/OccupancyGrid", "schemaEncoding": "ros2msg",
     "schema": "", "metadata": {"latched": "true"}}]})");
  expect_json(advertise_op({}), R"({"op": "advertise", "channels": []})");
  expect_json(unadvertise_op({1, 2}), R"({"op": "unadvertise", "channelIds": [1, 2]})");
}

TEST(ServerText, Services) {
  const std::vector<Service> services = {{10,
                                          "/arm",
                                          "std_srvs/srv/SetBool",
                                          {"std_srvs/srv/SetBool_Request", "bool data"},
                                          {"std_srvs/srv/SetBool_Response", "bool success\nstring message"}}};
  expect_json(advertise_services_op(services),
              R"({"op": "advertiseServices", "services": [{"id": 10, "name": "/arm",
    "type": "std_srvs/srv/SetBool",
    "request": {"encoding": "cdr", "schemaName": "std_srvs/srv/SetBool_Request", "schemaEncoding": "ros2msg", "schema": "bool data"},
    "response": {"encoding": "cdr", "schemaName": "std_srvs/srv/SetBool_Response", "schemaEncoding": "ros2msg",
                 "schema": "bool success\nstring message"}}]})");
  expect_json(unadvertise_services_op({10}), R"({"op": "unadvertiseServices", "serviceIds": [10]})");
  expect_json(service_failure_op(1, 2, "no"),
              R"({"op": "serviceCallFailure", "serviceId": 1, "callId": 2, "message": "no"})");
}

TEST(ServerText, Parameters) {
  expect_json(
      parameter_values_op({{"/a.b", 1.0}, {"/a.gone", {}}}, "request-123"),
      R"({"op": "parameterValues", "parameters": [{"name": "/a.b", "value": 1.0, "type": "float64"}, {"name": "/a.gone"}],
                  "id": "request-123"})");
  expect_json(parameter_values_op({}, std::nullopt), R"({"op": "parameterValues", "parameters": []})");
}

TEST(ServerText, Graph) {
  GraphDifference difference;
  difference.changed = {{{"/t1", {"p1", "p2"}}}, {{"/t2", {}}}, {{"/s1", {"n"}}}};
  difference.removed_topics = {"/t3"};
  difference.removed_services = {"/s2"};
  expect_json(graph_update_op(difference), R"({"op": "connectionGraphUpdate",
    "publishedTopics": [{"name": "/t1", "publisherIds": ["p1", "p2"]}],
    "subscribedTopics": [{"name": "/t2", "subscriberIds": []}],
    "advertisedServices": [{"name": "/s1", "providerIds": ["n"]}],
    "removedTopics": ["/t3"], "removedServices": ["/s2"]})");
}

TEST(ServerText, NamesOfOthersMayBeAnyBytes) {
  EXPECT_EQ(status_op(Level::info, "\xff"), "{\"op\":\"status\",\"level\":0,\"message\":\"\xEF\xBF\xBD\"}");
}

TEST(ServerBinary, MessageHead) {
  const std::array<std::uint8_t, 13> expected = {1,    0x78, 0x56, 0x34, 0x12, 0xF0, 0xDE,
                                                 0xBC, 0x9A, 0x78, 0x56, 0x34, 0x12};
  EXPECT_EQ(message_head(0x12345678, {0x123456789ABCDEF0}), expected);
  const std::array<std::uint8_t, 13> before_1970 = {1, 2};
  EXPECT_EQ(message_head(2, {-5}), before_1970);
}

TEST(ServerBinary, TimeOfTheRobot) {
  EXPECT_EQ(time_bytes({1'000'000'000}), (Bytes{2, 0x00, 0xCA, 0x9A, 0x3B, 0, 0, 0, 0}));
}

TEST(ServerBinary, ServiceResponse) {
  const Bytes payload = {7, 8};
  EXPECT_EQ(service_response_bytes(10, 12, "cdr", payload),
            (Bytes{3, 10, 0, 0, 0, 12, 0, 0, 0, 3, 0, 0, 0, 'c', 'd', 'r', 7, 8}));
}

TEST(ServerBinary, Assets) {
  const Bytes data = {7, 8};
  EXPECT_EQ(asset_bytes(10, data), (Bytes{4, 10, 0, 0, 0, 0, 0, 0, 0, 0, 7, 8}));
  EXPECT_EQ(asset_error_bytes(10, "no"), (Bytes{4, 10, 0, 0, 0, 1, 2, 0, 0, 0, 'n', 'o'}));
}

}  // namespace
}  // namespace bw::foxglove
