// A message set by paths has the bytes of its class, for all kinds of fields; paths that lead nowhere are
// refused.
#include "runtime/recording/import/message_draft.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>
#include <nav_msgs/msg/odometry.hpp>
#include <rosgraph_msgs/msg/clock.hpp>
#include <sensor_msgs/msg/joint_state.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <sensor_msgs/msg/nav_sat_fix.hpp>
#include <tf2_msgs/msg/tf_message.hpp>
#include <visualization_msgs/msg/marker.hpp>

#include "runtime/wire/serialization.hpp"
#include "runtime/wire/type_registry.hpp"
#include "runtime/wire/validate.hpp"

namespace bw::imports {
namespace {

using ::testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

template <class Message>
MessageDraft draft_of() {
  return MessageDraft(MessageTraits<Message>::description());
}

Bytes bytes_of(const MessageDraft& draft) {
  Bytes bytes;
  draft.write(bytes);
  return bytes;
}

template <class Message>
Bytes bytes_of_class(const Message& message) {
  Bytes bytes;
  serialize(message, bytes);
  return bytes;
}

TEST(MessageDraft, EveryTypeUnsetIsAMessageOfZeros) {
  for (const TypeDescription* type : all_types()) {
    const Bytes bytes = bytes_of(MessageDraft(*type));
    std::string reason;
    EXPECT_TRUE(validate(*type, bytes, &reason)) << reason;
  }
}

TEST(MessageDraft, NumbersTextsAndListsAreThoseOfTheClass) {
  MessageDraft draft = draft_of<sensor_msgs::msg::LaserScan>();
  draft.set_stamps(Time{12'000'000'345});
  draft.set(draft.find("header.frame_id"), std::string_view("laser"));
  draft.set(draft.find("angle_min"), -1.25);
  const std::vector<double> ranges = {1.0, std::numeric_limits<double>::infinity(), 2.5};
  draft.set(draft.find("ranges"), std::span<const double>(ranges));
  sensor_msgs::msg::LaserScan scan;
  scan.header().stamp().sec(12);
  scan.header().stamp().nanosec(345);
  scan.header().frame_id("laser");
  scan.angle_min(-1.25F);
  scan.ranges({1.0F, std::numeric_limits<float>::infinity(), 2.5F});
  EXPECT_EQ(bytes_of(draft), bytes_of_class(scan));
}

TEST(MessageDraft, ElementsOfArraysAndSequences) {
  MessageDraft fix = draft_of<sensor_msgs::msg::NavSatFix>();
  fix.set(fix.find("status.status"), -1.0);
  fix.set(fix.find("position_covariance[4]"), 0.25);
  sensor_msgs::msg::NavSatFix fix_message;
  fix_message.status().status(-1);
  fix_message.position_covariance()[4] = 0.25;
  EXPECT_EQ(bytes_of(fix), bytes_of_class(fix_message));

  MessageDraft joints = draft_of<sensor_msgs::msg::JointState>();
  joints.set(joints.find("name[1]"), std::string_view("right"));
  joints.set(joints.find("velocity[1]"), 3.0);
  sensor_msgs::msg::JointState joints_message;
  joints_message.name({"", "right"});
  joints_message.velocity({0.0, 3.0});
  EXPECT_EQ(bytes_of(joints), bytes_of_class(joints_message));

  MessageDraft tf = draft_of<tf2_msgs::msg::TFMessage>();
  tf.set(tf.find("transforms[1].transform.translation.y"), 7.0);
  tf.set_stamps(Time{5'000'000'000});
  tf2_msgs::msg::TFMessage tf_message;
  tf_message.transforms().resize(2);
  for (auto& transform : tf_message.transforms()) {
    transform.header().stamp().sec(5);
    transform.transform().rotation().w(0.0);
  }
  tf_message.transforms()[1].transform().translation().y(7.0);
  EXPECT_EQ(bytes_of(tf), bytes_of_class(tf_message));
}

// A quarter turn to the left: z = w = sin(pi / 4). Roll by pi alone: x = 1.
TEST(MessageDraft, AnglesBecomeAQuaternion) {
  MessageDraft draft = draft_of<nav_msgs::msg::Odometry>();
  draft.set(draft.find("pose.pose.orientation.yaw"), std::acos(-1.0) / 2.0);
  nav_msgs::msg::Odometry odometry;
  ASSERT_TRUE(deserialize(bytes_of(draft), odometry));
  EXPECT_NEAR(odometry.pose().pose().orientation().z(), std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(odometry.pose().pose().orientation().w(), std::sqrt(0.5), 1e-15);
  draft.set(draft.find("pose.pose.orientation.yaw"), 0.0);
  draft.set(draft.find("pose.pose.orientation.roll"), std::acos(-1.0));
  ASSERT_TRUE(deserialize(bytes_of(draft), odometry));
  EXPECT_NEAR(odometry.pose().pose().orientation().x(), 1.0, 1e-15);
}

TEST(MessageDraft, TimesAndDurations) {
  MessageDraft clock = draft_of<rosgraph_msgs::msg::Clock>();
  clock.set_stamps(Time{3'000'000'007});  // it begins with a time, without a header
  rosgraph_msgs::msg::Clock clock_message;
  clock_message.clock().sec(3);
  clock_message.clock().nanosec(7);
  EXPECT_EQ(bytes_of(clock), bytes_of_class(clock_message));
  MessageDraft marker = draft_of<visualization_msgs::msg::Marker>();
  marker.set(marker.find("lifetime"), Duration{-500'000'000});
  visualization_msgs::msg::Marker read;
  ASSERT_TRUE(deserialize(bytes_of(marker), read));
  EXPECT_EQ(read.lifetime().sec(), -1);
  EXPECT_EQ(read.lifetime().nanosec(), 500'000'000U);
}

std::string refusal(MessageDraft draft, const std::string& path) {
  try {
    draft.find(path);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(MessageDraft, PathsThatLeadNowhereAreRefused) {
  const MessageDraft scan = draft_of<sensor_msgs::msg::LaserScan>();
  EXPECT_THAT(refusal(scan, "angle_mim"), HasSubstr("sensor_msgs/msg/LaserScan has no 'angle_mim'"));
  EXPECT_THAT(refusal(scan, "angle_mim"), HasSubstr("did you mean 'angle_min'?"));
  EXPECT_THAT(refusal(scan, "header"),
              HasSubstr("is a whole std_msgs/msg/Header: one of its fields must be named"));
  EXPECT_THAT(refusal(scan, "angle_min.x"), HasSubstr("nothing is below 'angle_min'"));
  EXPECT_THAT(refusal(scan, "angle_min[0]"), HasSubstr("'angle_min' is no list"));
  EXPECT_THAT(refusal(scan, "ranges[x]"), HasSubstr("an element is written as name[0]"));
  EXPECT_THAT(refusal(scan, "ranges[1].x"), HasSubstr("nothing is below 'ranges'"));
  EXPECT_THAT(refusal(scan, ""), HasSubstr("a field must be named"));
  EXPECT_THAT(refusal(draft_of<sensor_msgs::msg::NavSatFix>(), "position_covariance[9]"),
              HasSubstr("'position_covariance' has 9 elements"));
  EXPECT_THAT(refusal(draft_of<tf2_msgs::msg::TFMessage>(), "transforms"),
              HasSubstr("name its elements, transforms[0]"));
  EXPECT_THAT(refusal(draft_of<nav_msgs::msg::Odometry>(), "pose.pose.orientation.yaw.x"),
              HasSubstr("nothing is below an angle"));
}

TEST(MessageDraft, ValuesThatDoNotFitAreRefused) {
  MessageDraft fix = draft_of<sensor_msgs::msg::NavSatFix>();
  EXPECT_EQ(fix.set(fix.find("status.status"), 128.0), "must be a whole number from -128 to 127");
  EXPECT_EQ(fix.set(fix.find("status.status"), 0.5), "must be a whole number from -128 to 127");
  EXPECT_EQ(fix.set(fix.find("status.status"), std::nan("")), "must be a whole number from -128 to 127");
  const std::vector<double> four(4, 1.0);
  EXPECT_EQ(fix.set(fix.find("position_covariance"), std::span<const double>(four)),
            "'position_covariance' has room for 9, not for 4");
  MessageDraft scan = draft_of<sensor_msgs::msg::LaserScan>();
  EXPECT_EQ(scan.set(scan.find("angle_min"), 1e39), "is too large for a float32");
}

}  // namespace
}  // namespace bw::imports
