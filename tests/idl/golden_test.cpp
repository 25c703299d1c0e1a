// The bytes of messages against bytes written by hand in the order of the ROS 2 definitions, both ways.
#include <gtest/gtest.h>

#include "geometry_msgs/msg/pose_stamped.hpp"
#include "geometry_msgs/msg/twist.hpp"
#include "map_msgs/msg/occupancy_grid_update.hpp"
#include "nav_msgs/msg/occupancy_grid.hpp"
#include "nav_msgs/msg/odometry.hpp"
#include "nav_msgs/msg/path.hpp"
#include "rosgraph_msgs/msg/clock.hpp"
#include "sensor_msgs/msg/joint_state.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"
#include "slam_toolbox/srv/deserialize_pose_graph.hpp"
#include "std_msgs/msg/empty.hpp"
#include "std_msgs/msg/string.hpp"
#include "tests/idl/cdr_writer.hpp"
#include "tf2_msgs/msg/tf_message.hpp"
#include "visualization_msgs/msg/marker_array.hpp"

namespace bw::test {
namespace {

template <class M>
void expect_wire(const M& message, const std::vector<std::uint8_t>& golden) {
  std::vector<std::uint8_t> bytes(3, 0xAA);  // reused buffers must not shine through the padding
  serialize(message, bytes);
  EXPECT_EQ(bytes, golden);
  M back;
  std::string reason;
  EXPECT_TRUE(deserialize(golden, back, &reason)) << reason;
  EXPECT_TRUE(back == message);
}

std::vector<std::uint8_t> hex(std::string_view digits) {
  std::vector<std::uint8_t> bytes;
  const auto value = [](char c) { return c <= '9' ? c - '0' : c - 'a' + 10; };
  for (std::size_t i = 0; i < digits.size();) {
    if (digits[i] == ' ') {
      ++i;
      continue;
    }
    bytes.push_back(static_cast<std::uint8_t>(value(digits[i]) * 16 + value(digits[i + 1])));
    i += 2;
  }
  return bytes;
}

std_msgs::msg::Header header(std::int32_t sec, std::uint32_t nanosec, const std::string& frame) {
  std_msgs::msg::Header result;
  result.stamp().sec(sec);
  result.stamp().nanosec(nanosec);
  result.frame_id(frame);
  return result;
}

geometry_msgs::msg::Pose pose(double x, double y, double z, double qz, double qw) {
  geometry_msgs::msg::Pose result;
  result.position().x(x);
  result.position().y(y);
  result.position().z(z);
  result.orientation().z(qz);
  result.orientation().w(qw);
  return result;
}

TEST(Golden, ClockInHex) {
  rosgraph_msgs::msg::Clock clock;
  clock.clock().sec(-1);
  clock.clock().nanosec(500000000);
  expect_wire(clock, hex("00010000 ffffffff 0065cd1d"));
}

TEST(Golden, StringInHex) {
  std_msgs::msg::String text;
  text.data("hi");
  expect_wire(text, hex("00010000 03000000 686900"));
}

TEST(Golden, EmptyInHex) { expect_wire(std_msgs::msg::Empty(), hex("00010000 00")); }

TEST(Golden, TwistInHex) {
  geometry_msgs::msg::Twist twist;
  twist.linear().x(0.5);
  twist.angular().z(-2.0);
  expect_wire(twist, hex("00010000 000000000000e03f 0000000000000000 0000000000000000"
                         "         0000000000000000 0000000000000000 00000000000000c0"));
}

TEST(Golden, PoseStampedInHex) {
  geometry_msgs::msg::PoseStamped message;
  message.header(header(1, 2, "odom"));
  message.pose(pose(1.0, -2.0, 0.5, 0.0, 1.0));
  // 4 + 4 + 4 + 5 bytes of header, then 7 of padding before the first double.
  expect_wire(message, hex("00010000 01000000 02000000 05000000 6f646f6d00 00000000000000"
                           "000000000000f03f 00000000000000c0 000000000000e03f"
                           "0000000000000000 0000000000000000 0000000000000000 000000000000f03f"));
}

TEST(Golden, TFMessageInHex) {
  tf2_msgs::msg::TFMessage message;
  geometry_msgs::msg::TransformStamped transform;
  transform.header(header(3, 0, "map"));
  transform.child_frame_id("odom");
  transform.transform().translation().x(1.0);
  transform.transform().rotation().w(1.0);
  message.transforms({transform});
  expect_wire(message, hex("00010000 01000000 03000000 00000000 04000000 6d617000 05000000 6f646f6d00 000000"
                           "000000000000f03f 0000000000000000 0000000000000000"
                           "0000000000000000 0000000000000000 0000000000000000 000000000000f03f"));
}

TEST(Golden, OccupancyGridUpdateInHex) {
  map_msgs::msg::OccupancyGridUpdate message;
  message.header(header(1, 2, "map"));
  message.x(-1);
  message.y(7);
  message.width(2);
  message.height(1);
  message.data({100, -1});
  expect_wire(message, hex("00010000 01000000 02000000 04000000 6d617000"
                           "ffffffff 07000000 02000000 01000000 02000000 64ff"));
}

TEST(Golden, DeserializePoseGraphInHex) {
  using slam_toolbox::srv::DeserializePoseGraph;
  DeserializePoseGraph::Request request;
  request.filename("m");
  request.match_type(slam_toolbox::srv::DeserializePoseGraph_Request_Constants::LOCALIZE_AT_POSE);
  request.initial_pose().x(1.0);
  request.initial_pose().y(-2.0);
  request.initial_pose().theta(0.5);
  // 4 + 2 + 1 bytes, then 1 of padding before the first double.
  expect_wire(request, hex("00010000 02000000 6d00 03 00"
                           "000000000000f03f 00000000000000c0 000000000000e03f"));
  expect_wire(DeserializePoseGraph::Response(), hex("00010000 00"));
}

TEST(Golden, TFMessage) {
  tf2_msgs::msg::TFMessage message;
  CdrWriter golden;
  golden.put<std::uint32_t>(2);
  for (int i = 0; i < 2; ++i) {
    geometry_msgs::msg::TransformStamped transform;
    transform.header(header(7 + i, 9, i == 0 ? "map" : "odom"));
    transform.child_frame_id("base_link");
    transform.transform().translation().y(4.5);
    transform.transform().rotation().z(0.6);
    transform.transform().rotation().w(0.8);
    message.transforms().push_back(transform);
    golden.header(7 + i, 9, i == 0 ? "map" : "odom").text("base_link").doubles(0, 4.5, 0, 0, 0, 0.6, 0.8);
  }
  expect_wire(message, golden.bytes());
}

TEST(Golden, Odometry) {
  nav_msgs::msg::Odometry message;
  message.header(header(12, 345, "odom"));
  message.child_frame_id("base_link");
  message.pose().pose(pose(1.5, 2.5, 0.0, 0.6, 0.8));
  message.twist().twist().linear().x(0.7);
  message.twist().twist().angular().z(-0.3);
  CdrWriter golden;
  golden.header(12, 345, "odom").text("base_link").doubles(1.5, 2.5, 0, 0, 0, 0.6, 0.8);
  for (std::size_t i = 0; i < 36; ++i) {
    message.pose().covariance()[i] = static_cast<double>(i);
    golden.doubles(i);
  }
  golden.doubles(0.7, 0, 0, 0, 0, -0.3);
  for (std::size_t i = 0; i < 36; ++i) {
    message.twist().covariance()[i] = -static_cast<double>(i);
    golden.doubles(-static_cast<double>(i));
  }
  expect_wire(message, golden.bytes());
}

TEST(Golden, LaserScan) {
  sensor_msgs::msg::LaserScan message;
  message.header(header(1, 2, "laser"));
  message.angle_min(-2.25F);
  message.angle_max(2.25F);
  message.angle_increment(0.00625F);
  message.time_increment(0.0F);
  message.scan_time(0.1F);
  message.range_min(0.05F);
  message.range_max(20.0F);
  CdrWriter golden;
  golden.header(1, 2, "laser").floats(-2.25, 2.25, 0.00625F, 0, 0.1F, 0.05F, 20).put<std::uint32_t>(720);
  for (int i = 0; i < 720; ++i) {
    message.ranges().push_back(static_cast<float>(i) / 64.0F);
    golden.floats(static_cast<float>(i) / 64.0F);
  }
  golden.put<std::uint32_t>(0);
  expect_wire(message, golden.bytes());
}

TEST(Golden, JointState) {
  sensor_msgs::msg::JointState message;
  message.header(header(1, 2, ""));
  message.name({"left", "right_wheel"});
  message.velocity({1.25, -1.25});
  CdrWriter golden;
  // No padding follows the length of an empty sequence.
  golden.header(1, 2, "").put<std::uint32_t>(2).text("left").text("right_wheel").put<std::uint32_t>(0);
  golden.put<std::uint32_t>(2).doubles(1.25, -1.25).put<std::uint32_t>(0);
  expect_wire(message, golden.bytes());
}

TEST(Golden, OccupancyGrid) {
  nav_msgs::msg::OccupancyGrid message;
  message.header(header(5, 6, "map"));
  message.info().map_load_time().sec(4);
  message.info().map_load_time().nanosec(44);
  message.info().resolution(0.05F);
  message.info().width(3);
  message.info().height(2);
  message.info().origin(pose(-1, -2, 0, 0, 1));
  message.data({0, 100, -1, 50, 0, 1});
  CdrWriter golden;
  golden.header(5, 6, "map").put<std::int32_t>(4).put<std::uint32_t>(44).floats(0.05F);
  golden.put<std::uint32_t>(3).put<std::uint32_t>(2).doubles(-1, -2, 0, 0, 0, 0, 1).put<std::uint32_t>(6);
  for (const int cell : {0, 100, -1, 50, 0, 1}) golden.put(static_cast<std::int8_t>(cell));
  expect_wire(message, golden.bytes());
}

TEST(Golden, Path) {
  nav_msgs::msg::Path message;
  message.header(header(8, 9, "map"));
  CdrWriter golden;
  golden.header(8, 9, "map").put<std::uint32_t>(3);
  for (int i = 0; i < 3; ++i) {
    geometry_msgs::msg::PoseStamped element;
    element.header(header(i, 0, std::string(static_cast<std::size_t>(i), 'm')));
    element.pose(pose(i, 0.5 * i, 0, 0, 1));
    message.poses().push_back(element);
    golden.header(i, 0, std::string(static_cast<std::size_t>(i), 'm')).doubles(i, 0.5 * i, 0, 0, 0, 0, 1);
  }
  expect_wire(message, golden.bytes());
}

TEST(Golden, MarkerArray) {
  namespace constants = visualization_msgs::msg::Marker_Constants;
  visualization_msgs::msg::Marker marker;
  marker.header(header(2, 3, "map"));
  marker.ns("people");
  marker.id(-4);
  marker.type(constants::LINE_STRIP);
  marker.action(constants::ADD);
  marker.pose(pose(0, 0, 0.1, 0, 1));
  marker.scale().x(0.02);
  marker.color().g(0.5F);
  marker.color().a(1.0F);
  marker.lifetime().sec(1);
  marker.lifetime().nanosec(250000000);
  marker.frame_locked(true);
  geometry_msgs::msg::Point point;
  point.x(3.0);
  marker.points({point, point});
  marker.colors().resize(1);
  marker.colors()[0].r(0.25F);
  marker.texture().format("png");
  marker.texture().data({1, 2, 3});
  marker.uv_coordinates().resize(1);
  marker.uv_coordinates()[0].v(0.75F);
  marker.text("walker");
  marker.mesh_file().data({9});
  visualization_msgs::msg::MarkerArray message;
  message.markers({marker});

  CdrWriter golden;
  golden.put<std::uint32_t>(1).header(2, 3, "map").text("people");
  golden.put<std::int32_t>(-4).put<std::int32_t>(4).put<std::int32_t>(0);
  golden.doubles(0, 0, 0.1, 0, 0, 0, 1).doubles(0.02, 0, 0).floats(0, 0.5, 0, 1);
  golden.put<std::int32_t>(1).put<std::uint32_t>(250000000).put<std::uint8_t>(1);
  golden.put<std::uint32_t>(2).doubles(3, 0, 0, 3, 0, 0);
  golden.put<std::uint32_t>(1).floats(0.25, 0, 0, 0).text("");
  golden.header(0, 0, "").text("png").put<std::uint32_t>(3);
  golden.put<std::uint8_t>(1).put<std::uint8_t>(2).put<std::uint8_t>(3);
  golden.put<std::uint32_t>(1).floats(0, 0.75).text("walker").text("");
  golden.text("").put<std::uint32_t>(1).put<std::uint8_t>(9).put<std::uint8_t>(0);
  expect_wire(message, golden.bytes());
}

}  // namespace
}  // namespace bw::test
