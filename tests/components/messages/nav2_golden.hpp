// What carries a goal of an action, its result and its feedback, against bytes written value by value in the
// order of the definitions by a hand that knows nothing of the product (tests/idl/cdr_writer.hpp), both ways.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <builtin_interfaces/msg/duration.hpp>
#include <geometry_msgs/msg/point.hpp>
#include <geometry_msgs/msg/pose_stamped.hpp>
#include <gtest/gtest.h>
#include <nav2_msgs/msg/waypoint_status.hpp>
#include <nav_msgs/msg/goals.hpp>
#include <nav_msgs/msg/path.hpp>

#include "tests/idl/cdr_writer.hpp"

namespace bw::test {

template <class M>
void expect_wire(const M& message, const std::vector<std::uint8_t>& golden) {
  std::vector<std::uint8_t> bytes(3, 0xAA);  // reused buffers must not shine through the padding
  serialize(message, bytes);
  EXPECT_EQ(bytes, golden) << MessageTraits<M>::ros_name;
  M back;
  std::string reason;
  EXPECT_TRUE(deserialize(golden, back, &reason)) << reason;
  EXPECT_EQ(back, message) << MessageTraits<M>::ros_name;
}

/// A message and how it is written.
template <class M>
struct Golden {
  M message;
  std::function<void(CdrWriter&)> write;
};

/// uint8[16]
inline void write_id(CdrWriter& w) {
  for (std::uint8_t byte = 0; byte < 16; ++byte) w.put<std::uint8_t>(byte + 0x20);
}

inline std::array<std::uint8_t, 16> id() {
  std::array<std::uint8_t, 16> bytes{};
  for (std::uint8_t i = 0; i < 16; ++i) bytes[i] = i + 0x20;
  return bytes;
}

template <class A>
void expect_action(const Golden<typename A::Goal>& goal, const Golden<typename A::Result>& result,
                   const Golden<typename A::Feedback>& feedback) {
  typename A::SendGoal::Request send;
  send.goal_id().uuid(id());
  send.goal(goal.message);
  CdrWriter sent;
  write_id(sent);
  goal.write(sent);
  expect_wire(send, sent.bytes());

  typename A::SendGoal::Response answer;
  answer.accepted(true);
  answer.stamp().sec(1700000000);
  answer.stamp().nanosec(999999999);
  expect_wire(
      answer,
      CdrWriter().put<std::uint8_t>(1).put<std::int32_t>(1700000000).put<std::uint32_t>(999999999).bytes());

  typename A::GetResult::Request ask;
  ask.goal_id().uuid(id());
  CdrWriter asked;
  write_id(asked);
  expect_wire(ask, asked.bytes());

  typename A::GetResult::Response end;
  end.status(6);
  end.result(result.message);
  CdrWriter ended;
  ended.put<std::int8_t>(6);
  result.write(ended);
  expect_wire(end, ended.bytes());

  typename A::FeedbackMessage report;
  report.goal_id().uuid(id());
  report.feedback(feedback.message);
  CdrWriter reported;
  write_id(reported);
  feedback.write(reported);
  expect_wire(report, reported.bytes());
}

inline geometry_msgs::msg::PoseStamped pose(double x) {
  geometry_msgs::msg::PoseStamped pose;
  pose.header().stamp().sec(12);
  pose.header().stamp().nanosec(340);
  pose.header().frame_id("map");
  pose.pose().position().x(x);
  pose.pose().position().y(-x);
  pose.pose().orientation().z(0.6);
  pose.pose().orientation().w(0.8);
  return pose;
}
/// Header header (Time stamp, string frame_id), Pose pose (Point position, Quaternion orientation)
inline void write_pose(CdrWriter& w, double x) {
  w.header(12, 340, "map").doubles(x, -x, 0.0, 0.0, 0.0, 0.6, 0.8);
}

inline nav_msgs::msg::Path path() {
  nav_msgs::msg::Path path;
  path.header().stamp().sec(9);
  path.header().frame_id("odom");
  path.poses({pose(1.0), pose(2.0)});
  return path;
}
/// Header header, PoseStamped[] poses
inline void write_path(CdrWriter& w) {
  w.header(9, 0, "odom").put<std::uint32_t>(2);
  write_pose(w, 1.0);
  write_pose(w, 2.0);
}

inline builtin_interfaces::msg::Duration duration(std::int32_t sec) {
  builtin_interfaces::msg::Duration duration;
  duration.sec(sec);
  duration.nanosec(500000000);
  return duration;
}
/// int32 sec, uint32 nanosec
inline void write_duration(CdrWriter& w, std::int32_t sec) {
  w.put<std::int32_t>(sec).put<std::uint32_t>(500000000);
}

inline geometry_msgs::msg::Point point() {
  geometry_msgs::msg::Point point;
  point.x(-0.3);
  point.y(0.1);
  point.z(0.2);
  return point;
}
inline void write_point(CdrWriter& w) { w.doubles(-0.3, 0.1, 0.2); }

/// A std_msgs/Empty, or a message without fields.
inline void write_nothing(CdrWriter& w) { w.put<std::uint8_t>(0); }

/// uint16 error_code, string error_msg
template <class Result>
void fail(Result& result, std::uint16_t code) {
  result.error_code(code);
  result.error_msg("why");
}
inline void write_error(CdrWriter& w, std::uint16_t code) { w.put<std::uint16_t>(code).text("why"); }

/// PoseStamped[]
inline std::vector<geometry_msgs::msg::PoseStamped> two_poses() { return {pose(3.0), pose(4.0)}; }
inline void write_two_poses(CdrWriter& w) {
  w.put<std::uint32_t>(2);
  write_pose(w, 3.0);
  write_pose(w, 4.0);
}

/// Header header, PoseStamped[] goals
inline nav_msgs::msg::Goals goals() {
  nav_msgs::msg::Goals goals;
  goals.header().stamp().sec(8);
  goals.header().frame_id("map");
  goals.goals(two_poses());
  return goals;
}
inline void write_goals(CdrWriter& w) {
  w.header(8, 0, "map");
  write_two_poses(w);
}

/// uint8 waypoint_status, uint32 waypoint_index, PoseStamped waypoint_pose, uint16 error_code, string
/// error_msg
inline nav2_msgs::msg::WaypointStatus waypoint_status() {
  nav2_msgs::msg::WaypointStatus status;
  status.waypoint_status(3);
  status.waypoint_index(1);
  status.waypoint_pose(pose(4.0));
  fail(status, 204);
  return status;
}
inline void write_waypoint_status(CdrWriter& w) {
  w.put<std::uint8_t>(3).put<std::uint32_t>(1);
  write_pose(w, 4.0);
  write_error(w, 204);
}

}  // namespace bw::test
