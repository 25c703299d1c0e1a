// The robot's side of a Foxglove server, beside programs on the same domain.
#include "runtime/remote/foxglove/wire_robot.hpp"

#include <string>
#include <vector>

#include <geometry_msgs/msg/pose_stamped.hpp>
#include <gmock/gmock.h>
#include <rosgraph_msgs/msg/clock.hpp>
#include <std_msgs/msg/float64.hpp>
#include <std_msgs/msg/string.hpp>

#include "runtime/ros/dds_names.hpp"
#include "runtime/stamps.hpp"
#include "tests/runtime/remote/foxglove/wire_rig.hpp"
#include "tests/runtime/remote/foxglove/wire_thing.hpp"

namespace bw::foxglove::test {
namespace {

using geometry_msgs::msg::PoseStamped;
using std_msgs::msg::Float64;
using std_msgs::msg::String;
using testing::ElementsAre;
using testing::HasSubstr;

template <class M>
dds::EndpointOptions end(const std::string& topic, const Qos& qos) {
  return {.topic = dds_topic(topic),
          .type = std::string(MessageTraits<M>::dds_name),
          .qos = qos,
          .user_data = user_data_of(std::string(MessageTraits<M>::type_hash)),
          .heartbeat = dds::kPromptHeartbeat};
}

Bytes text(const std::string& words) {
  String message;
  message.data(words);
  return bytes_of(message);
}

/// Another program.
struct Other {
  dds::Participant participant{{.network = network()}};

  std::unique_ptr<dds::Writer> writer(const std::string& topic, const Qos& qos = Qos::standard()) {
    return participant.create_writer(end<String>(topic, qos));
  }
};

// "abc" is 4 + 4 + 4 bytes, where DDS pads 7 of them to 8: what is passed on is the message.
TEST(WireRobot, PassesOnTheBytesOfWhatIsSubscribed) {
  Other other;
  const auto writer = other.writer("/words");
  Rig rig;
  const std::uint32_t id = rig.channel("/words");
  ASSERT_NE(id, 0U);
  EXPECT_EQ(rig.heard.channels[id].schema_name, "std_msgs/msg/String");
  EXPECT_EQ(rig.heard.channels[id].schema, "string data\n");
  EXPECT_EQ(writer->matched_readers(), 0) << "nobody has subscribed";

  rig.robot->subscribe(id);
  ASSERT_TRUE(rig.until([&] { return writer->matched_readers() == 1; }));
  for (const char* words : {"ab", "abc", "abcd"}) ASSERT_TRUE(writer->write(text(words)));
  ASSERT_TRUE(rig.until([&] { return rig.heard.messages.size() == 3; }));
  EXPECT_THAT(rig.heard.of(id), ElementsAre(text("ab"), text("abc"), text("abcd")));
  EXPECT_EQ(rig.heard.order.front(), "time") << "before the message it belongs to";

  rig.robot->unsubscribe(id);
  EXPECT_TRUE(rig.until([&] { return writer->matched_readers() == 0; })) << "what nobody hears costs nothing";
}

// One reader for each quality of service, and no message twice.
TEST(WireRobot, HearsReliableAndBestEffortWritersOfATopic) {
  Other other;
  const auto reliable = other.writer("/both");
  const auto quick = other.writer("/both", Qos::sensor());
  Rig rig;
  const std::uint32_t id = rig.channel("/both");
  rig.robot->subscribe(id);
  // The best-effort reader hears both writers, the reliable one its own.
  ASSERT_TRUE(rig.until([&] { return reliable->matched_readers() == 2 && quick->matched_readers() == 1; }));
  reliable->write(text("r"));
  quick->write(text("q"));
  reliable->write(text("end"));
  ASSERT_TRUE(rig.until([&] { return rig.heard.messages.size() >= 3; }));
  EXPECT_THAT(rig.heard.of(id), testing::UnorderedElementsAre(text("r"), text("q"), text("end")));
}

TEST(WireRobot, RemembersTheLastLatchedMessageOfEachWriter) {
  Other other;
  const auto map = other.writer("/latched", Qos::latched());
  const auto second = other.writer("/latched", Qos::latched());
  map->write(text("old"));
  map->write(text("map"));
  second->write(text("second"));
  Rig rig;
  const std::uint32_t id = rig.channel("/latched");
  EXPECT_TRUE(rig.heard.channels[id].is_latched);
  EXPECT_TRUE(rig.robot->latched(id).empty()) << "nobody has asked for it yet";
  rig.robot->subscribe(id);
  ASSERT_TRUE(rig.until([&] { return rig.heard.messages.size() == 2; }));
  EXPECT_THAT(rig.heard.of(id), testing::UnorderedElementsAre(text("map"), text("second")));

  rig.robot->subscribe(id);  // another client
  std::vector<Bytes> latched;
  for (const auto& [time, cdr] : rig.robot->latched(id)) latched.push_back(*cdr);
  EXPECT_THAT(latched, testing::UnorderedElementsAre(text("map"), text("second")));

  // Who comes when all have left gets it again.
  rig.robot->unsubscribe(id);
  rig.robot->unsubscribe(id);
  ASSERT_TRUE(rig.until([&] { return map->matched_readers() == 0; }));
  rig.robot->subscribe(id);
  EXPECT_TRUE(rig.until([&] { return rig.heard.messages.size() == 4; }));
}

TEST(WireRobot, ARobotThatComesBackHasItsChannelsAgain) {
  Rig rig;
  auto other = std::make_unique<Other>();
  auto writer = other->writer("/words");
  const std::uint32_t id = rig.channel("/words");
  rig.robot->subscribe(id);
  writer.reset();
  other.reset();
  ASSERT_TRUE(rig.until([&] { return rig.heard.channels.empty(); }));
  rig.robot->unsubscribe(id);  // of a channel that is gone: nothing

  other = std::make_unique<Other>();
  writer = other->writer("/words");
  EXPECT_EQ(rig.channel("/words"), id);
  rig.robot->subscribe(id);
  ASSERT_TRUE(rig.until([&] { return writer->matched_readers() == 1; }));
  writer->write(text("back"));
  EXPECT_TRUE(rig.until([&] { return !rig.heard.messages.empty(); }));
}

TEST(WireRobot, SaysOnceWhatItCannotShow) {
  Other other;
  const auto strange = other.participant.create_writer({.topic = "rt/strange",
                                                        .type = "odd_msgs::msg::dds_::Thing_",
                                                        .qos = Qos::standard(),
                                                        .user_data = {}});
  const auto words = other.writer("/words");
  const auto twin = other.participant.create_writer(end<Float64>("/numbers", Qos::standard()));
  Other third;
  Rig rig;
  rig.channel("/numbers");
  const auto other_type = third.participant.create_writer(end<String>("/numbers", Qos::standard()));
  const std::uint32_t id = rig.channel("/words");
  ASSERT_TRUE(rig.until([&] { return rig.heard.statuses.size() == 2; }));
  EXPECT_EQ(rig.heard.statuses[0],
            "/strange (odd_msgs/msg/Thing) is not shown: this program does not know the type");
  EXPECT_EQ(
      rig.heard.statuses[1],
      "/numbers (std_msgs/msg/String) is not shown: the topic is shown as another type, std_msgs/msg/Float64");
  EXPECT_EQ(rig.heard.channel("/strange"), nullptr);

  rig.robot->subscribe(id);
  ASSERT_TRUE(rig.until([&] { return words->matched_readers() == 1; }));
  words->write(Bytes{0, 1, 0, 0, 255, 255, 255, 255});
  words->write(text("good"));
  ASSERT_TRUE(rig.until([&] { return !rig.heard.messages.empty(); }));
  EXPECT_THAT(rig.heard.of(id), ElementsAre(text("good")));
  EXPECT_EQ(rig.heard.statuses.back(), "/words: a message that is no std_msgs/msg/String is left out");
}

// What is said first is not lost, though the reader is known only a moment later.
TEST(WireRobot, WhatClientsPublishArrivesFromTheFirstMessageOn) {
  Other other;
  const auto reader = other.participant.create_reader(end<PoseStamped>("/goal_pose", Qos::standard()), [] {});
  Rig rig;
  EXPECT_EQ(rig.robot->publish("/goal_pose", text("x")), "/goal_pose is not advertised");
  EXPECT_EQ(rig.robot->advertise("/goal_pose", "geometry_msgs/PoseStamped"), std::nullopt);
  EXPECT_EQ(rig.robot->publish_json("/goal_pose", R"({"pose": {"position": {"x": 1.5}}})"), std::nullopt);
  PoseStamped goal;
  goal.pose().position().y(2.0);
  EXPECT_EQ(rig.robot->publish("/goal_pose", bytes_of(goal)), std::nullopt);
  std::vector<PoseStamped> came;
  ASSERT_TRUE(rig.until([&] {
    dds::Sample sample;
    PoseStamped message;
    while (reader->take(sample)) {
      if (deserialize(sample.cdr, message)) came.push_back(message);
    }
    return came.size() == 2;
  }));
  EXPECT_EQ(came[0].pose().position().x(), 1.5);
  EXPECT_EQ(came[0].pose().orientation().w(), 1.0) << "not given: no rotation";
  EXPECT_EQ(came[1].pose().position().y(), 2.0);

  EXPECT_THAT(rig.robot->publish("/goal_pose", Bytes{0, 1, 0, 0}).value_or(""),
              HasSubstr("no geometry_msgs/msg/PoseStamped"));
  EXPECT_THAT(rig.robot->publish_json("/goal_pose", "{\"a\": 1}").value_or(""), HasSubstr("a"));
  EXPECT_THAT(rig.robot->advertise("/goal_pose", "std_msgs/String").value_or(""), HasSubstr("already"));
  EXPECT_THAT(rig.robot->advertise("/x", "odd_msgs/Thing").value_or(""), HasSubstr("does not know the type"));
  EXPECT_THAT(rig.robot->advertise("no topic", "std_msgs/String").value_or(""), HasSubstr("no topic"));
  rig.robot->unadvertise("/goal_pose");
  EXPECT_EQ(rig.robot->publish("/goal_pose", bytes_of(goal)), "/goal_pose is not advertised");
  EXPECT_TRUE(rig.until([&] { return reader->matched_writers() == 0; }));
}

TEST(WireRobot, ARunThatTakesNothingSaysSo) {
  Rig rig({.refusal = "this run takes nothing"});
  EXPECT_EQ(rig.robot->advertise("/goal_pose", "geometry_msgs/PoseStamped"), std::nullopt);
  EXPECT_EQ(rig.robot->publish_json("/goal_pose", "{}"), "/goal_pose: this run takes nothing");
}

TEST(WireRobot, TimeIsThatOfClockWhereSomebodyTellsIt) {
  using rosgraph_msgs::msg::Clock;
  Other other;
  const auto clock = other.participant.create_writer(end<Clock>("/clock", Qos::standard()));
  const auto words = other.writer("/words");
  Rig rig;
  rig.robot->subscribe(rig.channel("/words"));
  ASSERT_TRUE(rig.until([&] { return clock->matched_readers() == 1 && words->matched_readers() == 1; }));
  const auto step = [&](std::int32_t seconds, const std::string& said) {
    Clock message;
    message.clock().sec(seconds);
    ASSERT_TRUE(clock->write(bytes_of(message)));
    ASSERT_TRUE(words->write(text(said)));
    const std::size_t before = rig.heard.messages.size();
    ASSERT_TRUE(rig.until([&] { return rig.heard.messages.size() == before + 1; }));
    EXPECT_EQ(rig.heard.messages.back().received, Time::seconds(seconds));
    EXPECT_EQ(rig.heard.times.back(), Time::seconds(seconds));
  };
  step(100, "a");
  step(101, "b");
  step(5, "it began again");
}

TEST(WireRobot, TellsWhoTalksToWhomByNodes) {
  const Running robot(thing());
  Rig rig;
  ASSERT_TRUE(rig.until([&] { return rig.robot->graph().services.contains("/robot1/turn"); }));
  EXPECT_THAT(rig.robot->graph().services["/robot1/turn"], ElementsAre("/robot1/thing"));
  ASSERT_TRUE(rig.until([&] { return rig.robot->graph().published.contains("/rosout"); }));
  EXPECT_THAT(rig.robot->graph().published["/rosout"], testing::Not(testing::Contains("/viewer")))
      << "not itself";
  EXPECT_GT(rig.heard.graphs, 0);
}

}  // namespace
}  // namespace bw::foxglove::test
