// What clients are told and hear: beginning, channels, messages, time, graph, assets, notices.
#include <string>
#include <vector>

#include "tests/runtime/remote/foxglove/rig.hpp"

namespace bw::foxglove::test {
namespace {

std::string time_of(double seconds) {
  return Packed().le(std::uint8_t{2}).le(static_cast<std::uint64_t>(Time::seconds(seconds).nanoseconds));
}

TEST_F(Rig, TheBeginningIsServerInfoThenChannelsThenServices) {
  std::vector<Channel> channels;
  for (std::uint32_t id = 1; id <= 250; ++id) channels.push_back(channel(id, "/topic" + std::to_string(id)));
  server_->on_channels(channels, {});
  server_->on_services({service(7, "/arm")}, {});
  for (const std::string_view subprotocol : kSubprotocols) {
    open(1, true, subprotocol);
    const std::vector<json> ops = texts(1);
    ASSERT_EQ(ops.size(), 5U);
    EXPECT_EQ(ops[0],
              json::parse(R"({"op": "serverInfo", "name": "Bandwagon", "supportedEncodings": ["cdr", "json"],
      "capabilities": ["parameters", "parametersSubscribe", "services", "connectionGraph", "time", "clientPublish"],
      "metadata": {"ROS_DISTRO": "jazzy", "may_command": "true"}, "sessionId": "run 1"})"));
    // 250 channels in announcements of 100.
    EXPECT_EQ(ops[1].at("channels").size(), 100U);
    EXPECT_EQ(ops[2].at("channels").size(), 100U);
    EXPECT_EQ(ops[3].at("channels").size(), 50U);
    EXPECT_EQ(ops[4].at("op"), "advertiseServices");
    server_->on_close(1);
  }
}

TEST_F(Rig, WhoMayOnlyLookIsNotOfferedToPublish) {
  open(1, false);
  const std::vector<json> ops = texts(1);
  EXPECT_EQ(ops[0].at("capabilities"),
            json({"parameters", "parametersSubscribe", "services", "connectionGraph", "time"}));
  EXPECT_EQ(ops[0].at("metadata").at("may_command"), "false");
  EXPECT_EQ(ops[1],
            json::parse(R"({"op": "advertise", "channels": []})"));  // one at least, as the document says
  EXPECT_EQ(ops.back(), json::parse(R"({"op": "status", "level": 0, "id": "read_only",
      "message": "Read only: commands need a token"})"));
}

TEST_F(Rig, ChannelsAndServicesComeAndGo) {
  opened(1);
  server_->on_channels({channel(1, "/a")}, {});
  EXPECT_EQ(only_text(1).at("channels").at(0).at("topic"), "/a");
  subscribe(1, 5, 1);
  server_->on_channels({channel(2, "/a")}, {1, 99});  // of another type: the old one goes first
  const std::vector<json> ops = texts(1);
  ASSERT_EQ(ops.size(), 2U);
  EXPECT_EQ(ops[0], json::parse(R"({"op": "unadvertise", "channelIds": [1]})"));
  EXPECT_EQ(ops[1].at("channels").at(0).at("id"), 2);
  EXPECT_EQ(robot_.subscribers[1], 1);  // went with the channel: not given back
  subscribe(1, 5, 2);                   // the subscription went with its channel: its id is free
  EXPECT_TRUE(texts(1).empty());
  EXPECT_EQ(robot_.subscribers[2], 1);

  server_->on_services({service(1, "/s")}, {});
  EXPECT_EQ(only_text(1).at("services").at(0).at("name"), "/s");
  server_->on_services({}, {1, 2});
  EXPECT_EQ(only_text(1), json::parse(R"({"op": "unadvertiseServices", "serviceIds": [1]})"));
}

TEST_F(Rig, AChannelThatIsToldAgainKeepsItsSubscriptions) {
  opened(1);
  server_->on_channels({channel(1, "/a")}, {});
  subscribe(1, 5, 1);
  sender_.take(1);
  server_->on_channels({channel(1, "/a", true)}, {});  // now somebody latches
  EXPECT_TRUE(texts(1).empty());
  server_->on_message(1, Time::seconds(1), bytes_of("x"));
  EXPECT_EQ(payloads(1), std::vector<std::string>{message_bytes(5, Time::seconds(1), "x")});
}

TEST_F(Rig, MessagesGoToThoseWhoSubscribedWithTheirIds) {
  server_->on_channels({channel(1, "/a"), channel(2, "/b")}, {});
  for (const ConnectionId id : {1, 2, 3}) opened(id);
  EXPECT_EQ(robot_.subscribers[1], 0);  // what nobody hears costs nothing
  subscribe(1, 10, 1);
  subscribe(2, 20, 1);
  subscribe(2, 21, 2);
  EXPECT_EQ(robot_.subscribers[1], 2);
  server_->on_message(1, Time::seconds(1.5), bytes_of("abc"));
  const std::vector<Sent> first = sender_.take(1);
  ASSERT_EQ(first.size(), 1U);
  EXPECT_FALSE(first[0].is_text);
  EXPECT_EQ(first[0].bytes, message_bytes(10, Time::seconds(1.5), "abc"));
  EXPECT_EQ(first[0].keep.rule, Keep::Rule::newest);
  EXPECT_EQ(first[0].keep.stream, 1U);
  EXPECT_EQ(payloads(2), std::vector<std::string>{message_bytes(20, Time::seconds(1.5), "abc")});
  EXPECT_TRUE(payloads(3).empty());

  text(2, {{"op", "unsubscribe"}, {"subscriptionIds", {20}}});
  EXPECT_EQ(robot_.subscribers[1], 1);
  server_->on_message(1, Time::seconds(2), bytes_of("d"));
  EXPECT_TRUE(payloads(2).empty());
  server_->on_close(1);
  server_->on_close(2);
  EXPECT_EQ(robot_.subscribers[1], 0);
  EXPECT_EQ(robot_.subscribers[2], 0);
  server_->on_message(1, Time::seconds(3), bytes_of("e"));
  server_->on_message(99, Time::seconds(3), bytes_of("e"));
}

TEST_F(Rig, SubscriptionsThatCannotBeAreTold) {
  server_->on_channels({channel(1, "/a")}, {});
  opened(1);
  subscribe(1, 10, 1);
  EXPECT_TRUE(texts(1).empty());
  subscribe(1, 11, 1);
  expect_status(1, 1, "heard already, one subscription each: channels 1");
  subscribe(1, 10, 1);
  expect_status(1, 2, "ids in use already: 10");
  subscribe(1, 11, 77);
  expect_status(1, 2, "there are no channels 77");
  text(1, {{"op", "unsubscribe"}, {"subscriptionIds", {99}}});
  expect_status(1, 1, "there are no subscriptions 99");
  EXPECT_EQ(robot_.subscribers[1], 1);
}

TEST_F(Rig, AThousandSubscriptionsToEverythingAreOneOfEach) {
  constexpr std::uint32_t kChannels = 60;
  std::vector<Channel> channels;
  for (std::uint32_t id = 0; id < kChannels; ++id)
    channels.push_back(channel(id, "/topic" + std::to_string(id)));
  server_->on_channels(channels, {});
  opened(1);
  std::uint32_t next = 0;
  for (int i = 0; i < 1000; ++i) {
    json wanted = json::array();
    for (std::uint32_t id = 0; id < kChannels; ++id) wanted.push_back({{"id", next++}, {"channelId", id}});
    text(1, {{"op", "subscribe"}, {"subscriptions", wanted}});
  }
  // One warning for each op but the first, of bounded length.
  const std::vector<Sent> sent = sender_.take(1);
  EXPECT_EQ(sent.size(), 999U);
  for (const Sent& warning : sent) EXPECT_LT(warning.bytes.size(), 200U);
  for (std::uint32_t id = 0; id < kChannels; ++id) EXPECT_EQ(robot_.subscribers[id], 1);
  server_->on_message(7, Time::seconds(1), bytes_of("x"));
  EXPECT_EQ(payloads(1), std::vector<std::string>{message_bytes(7, Time::seconds(1), "x")});
}

TEST_F(Rig, LatchedMessagesAreSentAgainToEachNewSubscription) {
  server_->on_channels({channel(1, "/map", true), channel(2, "/odom")}, {});
  robot_.last[1] = {{Time::seconds(1), bytes_of("map")}};
  robot_.last[2] = {{Time::seconds(1), bytes_of("old")}};
  for (const ConnectionId id : {1, 2}) {
    opened(id);
    subscribe(id, 4, 1);
    subscribe(id, 5, 2);
    EXPECT_EQ(payloads(id), std::vector<std::string>{message_bytes(4, Time::seconds(1), "map")});
  }
  text(1, {{"op", "unsubscribe"}, {"subscriptionIds", {4}}});
  subscribe(1, 6, 1);
  EXPECT_EQ(payloads(1), std::vector<std::string>{message_bytes(6, Time::seconds(1), "map")});
}

TEST_F(Rig, OfALatchedTopicWithSeveralWritersNothingIsLeftOut) {
  server_->on_channels({channel(1, "/tf_static", true)}, {});
  opened(1);
  subscribe(1, 4, 1);
  robot_.last[1] = {{Time::seconds(1), bytes_of("a")}};
  server_->on_message(1, Time::seconds(1), bytes_of("a"));
  std::vector<Sent> sent = sender_.take(1);
  ASSERT_EQ(sent.size(), 1U);
  EXPECT_EQ(sent[0].keep.rule, Keep::Rule::newest);
  EXPECT_EQ(sent[0].keep.stream, 1U);
  robot_.last[1].push_back({Time::seconds(2), bytes_of("b")});
  server_->on_message(1, Time::seconds(2), bytes_of("b"));
  sent = sender_.take(1);
  ASSERT_EQ(sent.size(), 1U);
  EXPECT_EQ(sent[0].keep.rule, Keep::Rule::always);
  opened(2);
  subscribe(2, 4, 1);
  EXPECT_EQ(payloads(2), (std::vector<std::string>{message_bytes(4, Time::seconds(1), "a"),
                                                   message_bytes(4, Time::seconds(2), "b")}));
}

TEST_F(Rig, TheTimeGoesBeforeItsMessagesAndNoMoreThanAHundredTimesASecond) {
  server_->on_channels({channel(1, "/a")}, {});
  opened(1);
  subscribe(1, 4, 1);
  int times = 0;
  std::string last;
  for (int i = 0; i < 1000; ++i) {  // a message a millisecond for one second
    server_->on_time(Time::seconds(100 + 0.001 * i));
    server_->on_message(1, Time::seconds(100 + 0.001 * i), bytes_of("x"));
    const std::vector<std::string> sent = payloads(1);
    ASSERT_EQ(sent.back(), message_bytes(4, Time::seconds(100 + 0.001 * i), "x"));
    if (sent.size() == 2) {
      EXPECT_EQ(sent[0], time_of(100 + 0.001 * i));
      ++times;
    }
    pass(Duration::milliseconds(1));
  }
  EXPECT_EQ(times, 100);
}

TEST_F(Rig, AJumpBackIsToldAtOnce) {
  server_->on_channels({channel(1, "/a")}, {});
  opened(1);
  server_->on_time(Time::seconds(100));
  EXPECT_TRUE(payloads(1).empty());  // nothing to put in order yet
  server_->tick();
  EXPECT_EQ(payloads(1), std::vector<std::string>{time_of(100)});
  server_->on_time(Time::seconds(50));
  EXPECT_EQ(payloads(1), std::vector<std::string>{time_of(50)});
  server_->on_time(Time::seconds(50));
  server_->tick();
  EXPECT_TRUE(payloads(1).empty());
  open(2);
  EXPECT_EQ(payloads(2).back(), time_of(50));
}

TEST_F(Rig, TopicsThatOvertakeEachOtherAreNoJump) {
  server_->on_channels({channel(1, "/a")}, {});
  opened(1);
  subscribe(1, 4, 1);
  server_->on_time(Time::seconds(100));
  server_->on_message(1, Time::seconds(100), bytes_of("x"));
  server_->on_time(Time::seconds(99.51));
  server_->on_message(1, Time::seconds(99.51), bytes_of("y"));
  EXPECT_EQ(payloads(1), (std::vector<std::string>{time_of(100), message_bytes(4, Time::seconds(100), "x"),
                                                   message_bytes(4, Time::seconds(99.51), "y")}));
  server_->on_time(Time::seconds(99.5));
  EXPECT_EQ(payloads(1), std::vector<std::string>{time_of(99.5)});
}

TEST_F(Rig, ASlowClientMissesTimesTogetherWithData) {
  opened(1);
  server_->on_time(Time::seconds(1));
  server_->tick();
  const std::vector<Sent> sent = sender_.take(1);
  ASSERT_EQ(sent.size(), 1U);
  EXPECT_EQ(sent[0].keep.rule, Keep::Rule::newest);
  EXPECT_GT(sent[0].keep.stream, 0xFFFFFFFFU);  // no channel has it
}

TEST_F(Rig, TheGraphIsToldAsDifferences) {
  robot_.nodes = {{{"/a", {"/x"}}}, {}, {}};
  opened(1);
  opened(2);
  server_->on_graph();
  EXPECT_EQ(robot_.graphs_asked, 0);
  text(1, {{"op", "subscribeConnectionGraph"}});
  EXPECT_EQ(
      only_text(1),
      json::parse(
          R"({"op": "connectionGraphUpdate", "publishedTopics": [{"name": "/a", "publisherIds": ["/x"]}],
    "subscribedTopics": [], "advertisedServices": [], "removedTopics": [], "removedServices": []})"));
  text(1, {{"op", "subscribeConnectionGraph"}});
  expect_status(1, 1, "told already");
  server_->on_graph();
  EXPECT_TRUE(texts(1).empty());  // nothing has changed
  robot_.nodes = {{}, {{"/b", {"/y"}}}, {{"/s", {"/x"}}}};
  server_->on_graph();
  EXPECT_EQ(only_text(1), json::parse(R"({"op": "connectionGraphUpdate", "publishedTopics": [],
    "subscribedTopics": [{"name": "/b", "subscriberIds": ["/y"]}], "advertisedServices": [{"name": "/s", "providerIds": ["/x"]}],
    "removedTopics": ["/a"], "removedServices": []})"));
  EXPECT_TRUE(texts(2).empty());
  text(1, {{"op", "unsubscribeConnectionGraph"}});
  robot_.nodes = {};
  server_->on_graph();
  EXPECT_TRUE(texts(1).empty());
  text(1, {{"op", "unsubscribeConnectionGraph"}});
  expect_status(1, 1, "not subscribed");
}

TEST_F(Rig, AGraphThatChangedWhileNobodyHeardIsAskedAnew) {
  opened(1);
  text(1, {{"op", "subscribeConnectionGraph"}});
  server_->on_close(1);
  robot_.nodes = {{{"/new", {"/x"}}}, {}, {}};
  server_->on_graph();
  opened(2);
  text(2, {{"op", "subscribeConnectionGraph"}});
  EXPECT_EQ(only_text(2).at("publishedTopics").at(0).at("name"), "/new");
}

TEST_F(Rig, AssetsAreRefusedWithAReason) {
  opened(1);
  text(1, {{"op", "fetchAsset"}, {"uri", "package://a/b.urdf"}, {"requestId", 7}});
  const std::string reason = "assets are not served here; what a robot looks like is on its topics";
  const std::vector<Sent> sent = sender_.take(1);
  ASSERT_EQ(sent.size(), 1U);
  EXPECT_EQ(sent[0].keep.rule, Keep::Rule::always);
  EXPECT_EQ(sent[0].bytes, static_cast<std::string>(Packed()
                                                        .le(std::uint8_t{4})
                                                        .le(std::uint32_t{7})
                                                        .le(std::uint8_t{1})
                                                        .le(static_cast<std::uint32_t>(reason.size()))
                                                        .text(reason)));
}

TEST_F(Rig, AssetsWhereThereIsASource) {
  ServerOptions options;
  options.assets = [](const std::string& uri) -> std::variant<Bytes, std::string> {
    if (uri == "package://a/b.urdf") return Bytes{'x', 'y'};
    return "no " + uri;
  };
  start(std::move(options));
  open(1);
  EXPECT_EQ(texts(1)[0].at("capabilities").back(), "assets");
  text(1, {{"op", "fetchAsset"}, {"uri", "package://a/b.urdf"}, {"requestId", 7}});
  text(1, {{"op", "fetchAsset"}, {"uri", "c"}, {"requestId", 8}});
  EXPECT_EQ(payloads(1), (std::vector<std::string>{Packed()
                                                       .le(std::uint8_t{4})
                                                       .le(std::uint32_t{7})
                                                       .le(std::uint8_t{0})
                                                       .le(std::uint32_t{0})
                                                       .text("xy"),
                                                   Packed()
                                                       .le(std::uint8_t{4})
                                                       .le(std::uint32_t{8})
                                                       .le(std::uint8_t{1})
                                                       .le(std::uint32_t{4})
                                                       .text("no c")}));
}

TEST_F(Rig, NoticesOfTheRobotReachLateComers) {
  opened(1);
  for (int i = 0; i < 40; ++i) server_->on_status(1, "notice " + std::to_string(i));
  EXPECT_EQ(texts(1).size(), 40U);
  open(2);
  const std::vector<json> ops = texts(2);
  ASSERT_EQ(ops.size(), 3U + 32U);  // serverInfo, advertise, advertiseServices and the newest 32
  EXPECT_EQ(ops[3], json::parse(R"({"op": "status", "level": 1, "message": "notice 8"})"));
}

TEST_F(Rig, WhatIsNotUnderstoodIsToldAndHarmless) {
  opened(1);
  opened(2, true, kWebsocketV1);
  server_->on_text(1, "{");
  expect_status(1, 2, "Not understood: a text that is not JSON");
  binary(1, "");
  expect_status(1, 2, "Not understood: an empty binary message");
  const std::string pause =
      Packed().le(std::uint8_t{3}).le(std::uint8_t{1}).le(0U).le(std::uint8_t{0}).le(std::uint64_t{0}).le(0U);
  binary(1, pause);
  expect_status(1, 2, "Playback control is not offered");
  binary(2, pause);
  expect_status(2, 2, "binary opcode 3: no such opcode");
  server_->on_text(99, "{}");
  binary(99, "x");
  server_->on_close(99);
}

TEST_F(Rig, TheRobotIsLeftAtTheEnd) {
  EXPECT_EQ(robot_.listener, server_.get());
  server_.reset();
  EXPECT_EQ(robot_.listener, nullptr);
}

}  // namespace
}  // namespace bw::foxglove::test
