// What clients command, and who may.
#include <string>
#include <vector>

#include "tests/runtime/remote/foxglove/rig.hpp"

namespace bw::foxglove::test {
namespace {

class Commands : public Rig {
 protected:
  void advertise(ConnectionId id, std::uint32_t channel, const std::string& topic,
                 const std::string& encoding, const std::string& type = "geometry_msgs/PoseStamped") {
    text(id,
         {{"op", "advertise"},
          {"channels", {{{"id", channel}, {"topic", topic}, {"encoding", encoding}, {"schemaName", type}}}}});
  }
  void publish(ConnectionId id, std::uint32_t channel, const std::string& payload) {
    binary(id, Packed().le(std::uint8_t{1}).le(channel).text(payload));
  }
  void call(ConnectionId id, std::uint32_t service, std::uint32_t call, const std::string& encoding,
            const std::string& payload) {
    binary(id, Packed()
                   .le(std::uint8_t{2})
                   .le(service)
                   .le(call)
                   .le(static_cast<std::uint32_t>(encoding.size()))
                   .text(encoding)
                   .text(payload));
  }
  void expect_failure(ConnectionId id, std::uint32_t service, std::uint32_t call, const std::string& part) {
    const json op = only_text(id);
    EXPECT_EQ(op.value("op", ""), "serviceCallFailure") << op.dump();
    EXPECT_EQ(op.value("serviceId", 0U), service);
    EXPECT_EQ(op.value("callId", 0U), call);
    EXPECT_NE(op.value("message", "").find(part), std::string::npos) << op.dump();
  }
};

TEST_F(Commands, AreForwardedInBothEncodings) {
  opened(1);
  advertise(1, 1, "/goal_pose", "json");
  advertise(1, 2, "/initialpose", "cdr", "geometry_msgs/msg/PoseWithCovarianceStamped");
  EXPECT_TRUE(texts(1).empty());
  // Both spellings of a type are the same type.
  EXPECT_EQ(robot_.advertised, (std::map<std::string, std::string>{
                                   {"/goal_pose", "geometry_msgs/msg/PoseStamped"},
                                   {"/initialpose", "geometry_msgs/msg/PoseWithCovarianceStamped"}}));
  publish(1, 1, R"({"header":{}})");
  publish(1, 2, std::string("\0\1\0\0", 4));
  EXPECT_EQ(robot_.published,
            (std::vector<FakeRobot::Published>{{"/goal_pose", R"({"header":{}})", true},
                                               {"/initialpose", std::string("\0\1\0\0", 4), false}}));
  text(1, {{"op", "unadvertise"}, {"channelIds", {1}}});
  EXPECT_FALSE(robot_.advertised.contains("/goal_pose"));
  server_->on_close(1);
  EXPECT_TRUE(robot_.advertised.empty());
}

TEST_F(Commands, SeveralClientsShareATopicOfOneType) {
  opened(1);
  opened(2);
  advertise(1, 1, "/goal_pose", "json", "geometry_msgs/PoseStamped");
  advertise(2, 1, "/goal_pose", "cdr", "geometry_msgs/msg/PoseStamped");
  advertise(2, 2, "/goal_pose", "cdr", "geometry_msgs/msg/Pose");
  expect_status(
      2, 2,
      "advertise /goal_pose: a client publishes there as geometry_msgs/msg/PoseStamped, not as geometry_msgs/msg/Pose");
  server_->on_close(1);
  EXPECT_TRUE(robot_.advertised.contains("/goal_pose"));
  text(2, {{"op", "unadvertise"}, {"channelIds", {1}}});
  EXPECT_TRUE(robot_.advertised.empty());
}

TEST_F(Commands, ThatCannotBeAreTold) {
  opened(1);
  advertise(1, 1, "/a", "protobuf");
  expect_status(1, 2, "advertise /a: encoding \"protobuf\" is none of cdr, json");
  advertise(1, 1, "/a", "cdr", "Twist");
  expect_status(1, 2, "type \"Twist\" is not of the form");
  robot_.refusal = "the type is not known";
  advertise(1, 1, "/a", "cdr");
  expect_status(1, 2, "advertise /a: the type is not known");
  robot_.refusal.reset();
  advertise(1, 1, "/a", "cdr");
  EXPECT_TRUE(texts(1).empty());
  advertise(1, 1, "/b", "cdr");
  expect_status(1, 2, "advertise /b: channel 1 is in use already");
  publish(1, 7, "x");
  expect_status(1, 2, "publish: channel 7 was not advertised");
  text(1, {{"op", "unadvertise"}, {"channelIds", {7}}});
  expect_status(1, 1, "unadvertise: there is no channel 7");
  robot_.refusal = "3 bytes are no PoseStamped";
  publish(1, 1, "abc");
  const std::vector<json> ops = texts(1);
  ASSERT_EQ(ops.size(), 2U);  // it commands, and its command was refused
  EXPECT_EQ(
      ops[1],
      json::parse(
          R"({"op": "status", "level": 2, "message": "publish to /a: 3 bytes are no PoseStamped", "id": "publish /a"})"));
}

TEST_F(Commands, ChannelsOfAClientAreBounded) {
  opened(1);
  for (std::uint32_t id = 0; id < 256; ++id) advertise(1, id, "/t" + std::to_string(id), "json");
  EXPECT_TRUE(texts(1).empty());
  advertise(1, 256, "/more", "json");
  expect_status(1, 2, "256 channels of this client are open already");
}

TEST_F(Commands, ServicesAnswerTheirCalls) {
  server_->on_services({service(5, "/arm")}, {});
  opened(1);
  call(1, 5, 100, "cdr", "request");
  call(1, 5, 101, "json", "{}");
  ASSERT_EQ(robot_.calls.size(), 2U);
  EXPECT_EQ(robot_.calls[0].payload, "request");
  EXPECT_TRUE(robot_.calls[1].is_json);
  sender_.take(1);
  robot_.calls[1].answer(Bytes{'{', '}'});
  EXPECT_EQ(payloads(1), std::vector<std::string>{
                             Packed().le(std::uint8_t{3}).le(5U).le(101U).le(4U).text("json").text("{}")});
  robot_.calls[0].answer(Bytes{'x'});
  EXPECT_EQ(payloads(1), std::vector<std::string>{
                             Packed().le(std::uint8_t{3}).le(5U).le(100U).le(3U).text("cdr").text("x")});
  robot_.calls[0].answer(Bytes{'x'});  // answered already
  EXPECT_TRUE(payloads(1).empty());
  call(1, 5, 100, "cdr", "request");
  robot_.calls[2].answer(std::string("no reply within 5 s"));
  expect_failure(1, 5, 100, "no reply within 5 s");
}

TEST_F(Commands, CallsThatCannotBeFail) {
  server_->on_services({service(5, "/arm")}, {});
  opened(1);
  call(1, 6, 1, "cdr", "");
  expect_failure(1, 6, 1, "there is no service 6");
  call(1, 5, 1, "ros1", "");
  expect_failure(1, 5, 1, "encoding \"ros1\" is none of cdr, json");
  call(1, 5, 1, std::string(1000, '\xff'), "");
  expect_failure(1, 5, 1, "is none of cdr, json");
  for (std::uint32_t id = 0; id < 32; ++id) call(1, 5, id, "cdr", "");
  sender_.take(1);
  call(1, 5, 3, "cdr", "");
  expect_failure(1, 5, 3, "call 3 is in flight already");
  call(1, 5, 32, "cdr", "");
  expect_failure(1, 5, 32, "32 calls are in flight already");
  EXPECT_EQ(robot_.calls.size(), 32U);
  server_->on_close(1);
  for (const FakeRobot::Call& made : robot_.calls) made.answer(Bytes{});
  EXPECT_TRUE(payloads(1).empty());
}

TEST_F(Commands, AnAnswerAfterTheServersEndIsDropped) {
  server_->on_services({service(5, "/arm")}, {});
  opened(1);
  call(1, 5, 1, "cdr", "");
  server_.reset();
  sender_.take(1);
  robot_.calls[0].answer(Bytes{});
  EXPECT_TRUE(payloads(1).empty());
}

TEST_F(Commands, WhoMayOnlyLookIsRefusedEachWay) {
  server_->on_services(
      {service(5, "/arm"), service(6, "/planner/get_parameters", "rcl_interfaces/srv/GetParameters")}, {});
  opened(1, false);
  const std::string reason = "read only: commands need a token";
  advertise(1, 1, "/goal_pose", "json");
  expect_status(1, 2, "advertise /goal_pose: " + reason);
  publish(1, 1, "{}");
  expect_status(1, 2, "publish: channel 1 was not advertised");
  call(1, 5, 1, "json", "{}");
  expect_failure(1, 5, 1, reason);
  EXPECT_TRUE(robot_.advertised.empty());
  EXPECT_TRUE(robot_.published.empty());
  EXPECT_TRUE(robot_.calls.empty());
  call(1, 6, 2, "json", "{}");  // only asks
  EXPECT_EQ(robot_.calls.size(), 1U);
  EXPECT_TRUE(texts(1).empty());
}

TEST_F(Commands, TheLastCommanderIsShownToAll) {
  for (const ConnectionId id : {1, 2}) opened(id);
  advertise(1, 1, "/goal_pose", "json");
  advertise(2, 1, "/goal_pose", "json");
  EXPECT_TRUE(texts(1).empty());  // to announce is no command
  publish(1, 1, "{}");
  publish(1, 1, "{}");
  const std::vector<Sent> sent = sender_.take(1);
  ASSERT_EQ(sent.size(), 1U);
  EXPECT_EQ(
      json::parse(sent[0].bytes),
      json::parse(R"({"op": "status", "level": 0, "message": "You command the robot", "id": "commander"})"));
  EXPECT_EQ(sent[0].keep.rule, Keep::Rule::latched);
  EXPECT_EQ(
      only_text(2),
      json::parse(
          R"({"op": "status", "level": 0, "message": "127.0.0.1:50001 commands the robot", "id": "commander"})"));
  open(3);
  EXPECT_EQ(texts(3).back().at("message"), "127.0.0.1:50001 commands the robot");
  publish(2, 1, "{}");  // on loopback everybody may
  EXPECT_EQ(robot_.published.size(), 3U);
  EXPECT_EQ(only_text(1).at("message"), "127.0.0.1:50002 commands the robot");
  EXPECT_EQ(only_text(2).at("message"), "You command the robot");
  pass(Duration::milliseconds(10'000));
  server_->tick();
  EXPECT_EQ(only_text(1), json::parse(R"({"op": "removeStatus", "statusIds": ["commander"]})"));
}

TEST_F(Commands, OpenToTheNetworkThereIsOneCommanderAtATime) {
  ServerOptions options;
  options.is_one_commander = true;
  start(std::move(options));
  server_->on_services({service(5, "/arm")}, {});
  for (const ConnectionId id : {1, 2}) opened(id);
  advertise(1, 1, "/goal_pose", "json");
  advertise(2, 1, "/goal_pose", "json");
  publish(1, 1, "{}");
  EXPECT_EQ(only_text(1).at("level"), 0);
  EXPECT_EQ(
      only_text(2),
      json::parse(
          R"({"op": "status", "level": 1, "message": "127.0.0.1:50001 commands the robot", "id": "commander"})"));

  advertise(2, 2, "/robot1/emergency_stop", "json");
  publish(2, 2, R"({"data": true})");  // whose turn it is or not
  ASSERT_EQ(robot_.published.size(), 2U);
  EXPECT_EQ(robot_.published.back().topic, "/robot1/emergency_stop");
  EXPECT_TRUE(texts(2).empty());

  const std::string reason =
      "127.0.0.1:50001 commands the robot; it is another one's turn 10 s after its last command";
  publish(2, 1, "{}");
  EXPECT_EQ(only_text(2).at("message"), "publish to /goal_pose: " + reason);
  call(2, 5, 1, "json", "{}");
  expect_failure(2, 5, 1, reason);
  text(2, {{"op", "setParameters"}, {"parameters", {{{"name", "/a.b"}, {"value", true}}}}});
  expect_status(2, 2, "setParameters: " + reason);
  EXPECT_EQ(robot_.published.size(), 2U);
  EXPECT_TRUE(robot_.calls.empty());
  EXPECT_TRUE(robot_.sets.empty());

  server_->on_close(1);
  EXPECT_EQ(only_text(2), json::parse(R"({"op": "removeStatus", "statusIds": ["commander"]})"));
  publish(2, 1, "{}");
  EXPECT_EQ(robot_.published.size(), 3U);
  EXPECT_EQ(only_text(2).at("message"), "You command the robot");
}

}  // namespace
}  // namespace bw::foxglove::test
