// Which topics of a bag are played, and what their writers offer: by rosbag2's rules, and what is usual where
// nothing was recorded.
#include "runtime/recording/replay/played_topics.hpp"

#include <functional>
#include <stdexcept>

#include <gmock/gmock.h>

#include "runtime/recording/bag/qos_text.hpp"

namespace bw::replay {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::vector<bag::BagTopic> kRecorded = {
    {.name = "/odom", .type = "nav_msgs/msg/Odometry", .writer = "base"},
    {.name = "/odom", .type = "nav_msgs/msg/Odometry", .writer = "other"},
    {.name = "/clock", .type = "rosgraph_msgs/msg/Clock"},
    {.name = "/odd", .type = "odd_msgs/msg/Reading", .type_hash = "RIHS01_77"},
    {.name = "/json", .type = "a/msg/B", .serialization_format = "json"},
    {.name = "/typeless", .type = ""}};

std::vector<std::string> names(const TopicSelection& selection) {
  std::vector<std::string> out;
  for (const auto& topic : played_topics(kRecorded, selection)) out.push_back(topic ? topic->name : "");
  return out;
}

std::string said_by(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST(PlayedTopics, AllOfCdrThatHaveAType) {
  EXPECT_THAT(names({}), ElementsAre("/odom", "/odom", "/clock", "/odd", "", ""));
}

TEST(PlayedTopics, AreChosenExcludedAndRenamed) {
  EXPECT_THAT(names({.topics = {"/odom"}}), ElementsAre("/odom", "/odom", "", "", "", ""));
  EXPECT_THAT(names({.exclude = std::regex("^/od")}), ElementsAre("", "", "/clock", "", "", ""));
  EXPECT_THAT(names({.remaps = {{"/odom", "/base/odom"}}}),
              ElementsAre("/base/odom", "/base/odom", "/clock", "/odd", "", ""));
  EXPECT_THAT(names({.without_clock = true}), ElementsAre("/odom", "/odom", "", "/odd", "", ""));
}

TEST(PlayedTopics, WhatMakesNoSenseIsRefusedInWords) {
  EXPECT_THAT(said_by([] { names({.topics = {"/odo"}}); }),
              HasSubstr("--topics /odo: unknown topic; did you mean '/odom'"));
  EXPECT_THAT(said_by([] { names({.remaps = {{"/x", "/y"}}}); }), HasSubstr("--remap /x: unknown topic"));
  EXPECT_THAT(said_by([] { names({.remaps = {{"/odom", "1x"}}}); }), HasSubstr("must be a topic name"));
  EXPECT_THAT(said_by([] { names({.remaps = {{"/odom", "x"}}}); }), HasSubstr("must begin with /"));
  EXPECT_THAT(said_by([] {
                names({.remaps = {{"/odom", "/odd"}}});
              }),
              HasSubstr("/odd was recorded as nav_msgs/msg/Odometry and as odd_msgs/msg/Reading"));
  EXPECT_THAT(said_by([] { names({.exclude = std::regex(".")}); }), HasSubstr("nothing to play"));
}

TEST(PlayedTopics, CarryTheHashOfTheBagElseOurs) {
  const auto topics = played_topics(kRecorded, {});
  EXPECT_EQ(topics[3]->type_hash, "RIHS01_77");
  // Of Jazzy's generator.
  EXPECT_EQ(topics[0]->type_hash, "RIHS01_3cc97dc7fb7502f8714462c526d369e35b603cfc34d946e3f2eda2766dfec6e0");
}

TEST(PlayingQos, IsWhatWasRecorded) {
  const Qos sensor = playing_qos(
      {.name = "/scan", .type = "x/msg/Y", .offered_qos_profiles = bag::to_qos_text({Qos::sensor()})});
  EXPECT_EQ(sensor.reliability, Reliability::best_effort);
  EXPECT_EQ(sensor.durability, Durability::volatile_);
  const Qos latched = playing_qos(
      {.name = "/map", .type = "x/msg/Y", .offered_qos_profiles = bag::to_qos_text({Qos::latched()})});
  EXPECT_EQ(latched.durability, Durability::transient_local);
}

TEST(PlayingQos, FallsBackByNameAndType) {
  EXPECT_EQ(playing_qos({.name = "/x", .type = "x/msg/Y"}), Qos::standard(10));
  EXPECT_EQ(playing_qos({.name = "/rosout", .type = "rcl_interfaces/msg/Log"}), Qos::rosout());
  EXPECT_EQ(playing_qos({.name = "/map", .type = "nav_msgs/msg/OccupancyGrid"}), Qos::latched());
  EXPECT_EQ(playing_qos({.name = "/tf_static", .type = "tf2_msgs/msg/TFMessage"}), Qos::tf_static());
  EXPECT_EQ(playing_qos({.name = "/tf", .type = "tf2_msgs/msg/TFMessage"}), Qos::standard(10));
}

TEST(PlayingQos, KeepsEveryMessageOfTfStaticForWhoComesLate) {
  // 300 broadcasters in a bag that knows no nodes are one writer here.
  EXPECT_EQ(playing_qos({.name = "/tf_static",
                         .type = "tf2_msgs/msg/TFMessage",
                         .offered_qos_profiles = bag::to_qos_text({Qos::latched()}),
                         .message_count = 300})
                .depth,
            300);
}

}  // namespace
}  // namespace bw::replay
