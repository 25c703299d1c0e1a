// Messages as Foxglove's panels write them in JSON, and replies as they read them.
#include "runtime/remote/foxglove/message_json.hpp"

#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <geometry_msgs/msg/pose_stamped.hpp>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <std_msgs/msg/string.hpp>
#include <std_srvs/srv/empty.hpp>

#include "runtime/remote/foxglove/json_bounds.hpp"
#include "runtime/wire/serialization.hpp"
#include "runtime/wire/type_registry.hpp"
#include "tests/runtime/largest_allocation.hpp"

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

// The goal of the 3D panel: time as {sec, nsec}; with ROS 1's header where it takes the robot for one of
// those.
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

// 100,000 values and 32 levels, as in YAML: refused before memory is taken for them. A tree of 4 MB of
// brackets took 350 MB.
TEST(MessageJson, TooMuchIsRefused) {
  std::string list = "0";
  for (int i = 0; i < 100'000; ++i) list += ",0";
  EXPECT_THAT(refusal<LaserScan>("{\"ranges\": [" + list + "]}"), HasSubstr("more than 100000 values"));
  const auto nested = [](std::size_t levels) {
    return "{\"pose\": " + std::string(levels, '[') + std::string(levels, ']') + "}";
  };
  EXPECT_THAT(refusal<PoseStamped>(nested(31)), HasSubstr("must be a map"));
  largest_allocation = 0;
  EXPECT_THAT(refusal<PoseStamped>(nested(32)), HasSubstr("nested deeper than 32 levels"));
  const std::string brackets(std::size_t{4} << 20, '[');
  const std::string texts = "[\"" + std::string(std::size_t{4} << 20, '[') + "\"]";
  largest_allocation = 0;
  EXPECT_THAT(refusal<PoseStamped>(brackets), HasSubstr("nested deeper than 32 levels"));
  EXPECT_LT(largest_allocation, 4096U);
  EXPECT_THAT(refusal<PoseStamped>(texts), HasSubstr("is an object of JSON"))
      << "brackets in a text are none";
}

TEST(JsonBounds, CountWhatIsOpenAndWhatThereIs) {
  EXPECT_EQ(broken_bound(R"({"a": [1, 2], "b,[{": "\"[,"})", 2, 5), std::nullopt);  // the root, a, 1, 2, b
  EXPECT_EQ(broken_bound(R"({"a": [1, 2], "b,[{": "\"[,"})", 1, 5), "nested deeper than 1 levels");
  EXPECT_EQ(broken_bound(R"({"a": [1, 2], "b,[{": "\"[,"})", 2, 4), "of more than 4 values");
  EXPECT_EQ(broken_bound("[[],[],[]]", 2, 100), std::nullopt);  // side by side is not within each other
  for (const std::string broken : {"", "]", "]]]]", "\"", "\"\\", "\\", "[\"\\\"]"})
    EXPECT_EQ(broken_bound(broken, 1, 2), std::nullopt) << broken;
}

// Whatever comes is a message or refused with a reason, and takes no more memory than in proportion.
TEST(MessageJson, MutatedTextsAreTakenOrRefused) {
  const std::string seed =
      R"({"header": {"stamp": {"sec": 1, "nsec": 2}, "frame_id": "a\u00e4"}, "pose": {"position": {"x": 1e3}}})";
  const std::string pieces[] = {
      "[", "{", "]", "}", "\"", "\\", ",", ":", "null", "1e999", std::string(40, '[')};
  std::mt19937 random(7);
  largest_allocation = 0;
  for (int i = 0; i < 5000; ++i) {
    std::string text = seed;
    for (std::size_t n = 1 + random() % 4; n > 0; --n) {
      const std::size_t at = random() % text.size();
      if (random() % 2 == 0)
        text.erase(at, 1 + random() % 8);
      else
        text.insert(at, pieces[random() % std::size(pieces)]);
      if (text.empty()) text = "{";
    }
    static_cast<void>(refusal<PoseStamped>(text));
  }
  EXPECT_LT(largest_allocation, 64U << 10);
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
