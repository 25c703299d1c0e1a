// Messages as Foxglove's panels write them in JSON, and replies as they read them.
#include "runtime/foxglove/message_json.hpp"

#include <limits>
#include <string>
#include <vector>

#include <geometry_msgs/msg/pose_stamped.hpp>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <std_msgs/msg/string.hpp>
#include <std_srvs/srv/empty.hpp>

#include "runtime/wire/serialization.hpp"
#include "runtime/wire/type_registry.hpp"

namespace bw::foxglove {
namespace {

using geometry_msgs::msg::PoseStamped;
using sensor_msgs::msg::LaserScan;
using testing::HasSubstr;

template <class M>
M message(const std::string& json) {
  M m;
  EXPECT_TRUE(deserialize(message_from_json(*find_type(MessageTraits<M>::ros_name), json), m)) << json;
  return m;
}

template <class M>
std::string refusal(const std::string& json) {
  try {
    static_cast<void>(message_from_json(*find_type(MessageTraits<M>::ros_name), json));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "taken";
}

template <class M>
nlohmann::json json_of(const M& m) {
  std::vector<std::uint8_t> cdr;
  serialize(m, cdr);
  return nlohmann::json::parse(message_to_json(*find_type(MessageTraits<M>::ros_name), cdr));
}

// The goal of the 3D panel: time as {sec, nsec}; with ROS 1's header where it takes the robot for one of those.
TEST(MessageJson, APanelsGoalIsAPose) {
  const auto goal = message<PoseStamped>(
      R"({"header": {"seq": 3, "stamp": {"sec": 1700000000, "nsec": 250000000}, "frame_id": "map"},
          "pose": {"position": {"x": 1, "y": -2.5, "z": null}, "orientation": {"x": 0, "y": 0, "z": 0.6, "w": 0.8}}})");
  EXPECT_EQ(goal.header().stamp().sec(), 1700000000);
  EXPECT_EQ(goal.header().stamp().nanosec(), 250000000U);
  EXPECT_EQ(goal.header().frame_id(), "map");
  EXPECT_EQ(goal.pose().position().x(), 1.0);
  EXPECT_EQ(goal.pose().position().y(), -2.5);
  EXPECT_EQ(goal.pose().orientation().w(), 0.8);
}

TEST(MessageJson, TextComesWithItsEscapes) {
  EXPECT_EQ(message<std_msgs::msg::String>(R"({"data": "a\/b \ud83d\ude00 true: 1"})").data(),
            "a/b \U0001F600 true: 1");
}

TEST(MessageJson, WhatTheTypeDoesNotHaveIsRefusedWithItsName) {
  EXPECT_THAT(refusal<PoseStamped>(R"({"pose": {"position": {"q": 1}}})"), HasSubstr("pose.position.q"));
  EXPECT_THAT(refusal<PoseStamped>(R"({"pose": {"position": {"x": "1"}}})"), HasSubstr("must be a number"));
  EXPECT_THAT(refusal<PoseStamped>(R"({"pose": {"position": {"x": {"y": 1}}}})"),
              HasSubstr("must be a number"));
  EXPECT_THAT(refusal<LaserScan>(R"({"ranges": {"0": 1}})"), HasSubstr("must be a list"));
  EXPECT_THAT(refusal<PoseStamped>("[1]"), HasSubstr("is an object of JSON"));
  EXPECT_THAT(refusal<PoseStamped>("{\"pose\":"), HasSubstr("is an object of JSON"));
}

// 100,000 values, as in YAML; and depth costs nothing, since it goes as deep as the type.
TEST(MessageJson, TooMuchIsRefused) {
  std::string list = "0";
  for (int i = 0; i < 100'000; ++i) list += ",0";
  EXPECT_THAT(refusal<LaserScan>("{\"ranges\": [" + list + "]}"), HasSubstr("more than 100000 values"));
  const std::string deep = std::string(200'000, '[') + std::string(200'000, ']');
  EXPECT_THAT(refusal<PoseStamped>("{\"pose\": " + deep + "}"), HasSubstr("must be a map"));
}

TEST(MessageJson, AMessageReadsBack) {
  LaserScan scan;
  scan.header().frame_id("laser");
  scan.header().stamp().nanosec(7);
  scan.ranges({1.5F, std::numeric_limits<float>::infinity()});
  const nlohmann::json json = json_of(scan);
  EXPECT_EQ(json["header"]["stamp"]["nanosec"], 7);
  EXPECT_EQ(json["header"]["frame_id"], "laser");
  EXPECT_EQ(json["ranges"], nlohmann::json::parse("[1.5, null]"));  // JSON has no infinity
  EXPECT_EQ(json_of(std_srvs::srv::Empty::Response()), nlohmann::json::object());
}

TEST(MessageJson, BytesThatAreNoMessageAreRefused) {
  const std::vector<std::uint8_t> half = {0, 1, 0, 0, 1};
  EXPECT_THROW(static_cast<void>(message_to_json(*find_type("geometry_msgs/msg/PoseStamped"), half)),
               std::runtime_error);
}

}  // namespace
}  // namespace bw::foxglove
