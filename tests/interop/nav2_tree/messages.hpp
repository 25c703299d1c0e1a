// The messages that Nav2's behaviour tree and lifecycle manager exchange with servers, in Jazzy's layouts, as
// bytes by the letter of the definitions: nav_msgs/Path, the goals and results of nav2_msgs' actions,
// bond/Status, geometry_msgs/Twist.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "tests/interop/plain/cdr.hpp"

namespace nav2 {

using plain::Bytes;
using plain::CdrIn;
using plain::CdrOut;

struct Stamp {
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;
  bool operator==(const Stamp&) const = default;
};

struct Header {
  Stamp stamp;
  std::string frame = "map";
  bool operator==(const Header&) const = default;
};

struct Pose {
  double x = 0.0, y = 0.0, z = 0.0;
  double qx = 0.0, qy = 0.0, qz = 0.0, qw = 1.0;
  bool operator==(const Pose&) const = default;

  double yaw() const { return 2.0 * std::atan2(qz, qw); }
  static Pose of(double x, double y, double yaw) {
    return {.x = x, .y = y, .qz = std::sin(yaw / 2.0), .qw = std::cos(yaw / 2.0)};
  }
};

struct PoseStamped {
  Header header;
  Pose pose;
  bool operator==(const PoseStamped&) const = default;
};

struct Path {
  Header header;
  std::vector<PoseStamped> poses;
  bool operator==(const Path&) const = default;
};

inline void write(CdrOut& out, const Header& header) {
  out.number(header.stamp.sec).number(header.stamp.nanosec).text(header.frame);
}

inline void write(CdrOut& out, const PoseStamped& stamped) {
  write(out, stamped.header);
  const Pose& p = stamped.pose;
  for (const double value : {p.x, p.y, p.z, p.qx, p.qy, p.qz, p.qw}) out.number(value);
}

inline void write(CdrOut& out, const Path& path) {
  write(out, path.header);
  out.number(static_cast<std::uint32_t>(path.poses.size()));
  for (const PoseStamped& pose : path.poses) write(out, pose);
}

inline Header read_header(CdrIn& in) {
  Header header;
  header.stamp.sec = in.number<std::int32_t>();
  header.stamp.nanosec = in.number<std::uint32_t>();
  header.frame = in.text();
  return header;
}

/// geometry_msgs/Transform has the same fields in the same order.
inline Pose read_pose(CdrIn& in) {
  Pose p;
  for (double* value : {&p.x, &p.y, &p.z, &p.qx, &p.qy, &p.qz, &p.qw}) *value = in.number<double>();
  return p;
}

inline PoseStamped read_pose_stamped(CdrIn& in) {
  PoseStamped stamped;
  stamped.header = read_header(in);
  stamped.pose = read_pose(in);
  return stamped;
}

inline Path read_path(CdrIn& in) {
  Path path{.header = read_header(in), .poses = {}};
  for (auto left = in.number<std::uint32_t>(); left > 0; --left) path.poses.push_back(read_pose_stamped(in));
  return path;
}

/// nav2_msgs/action/ComputePathToPose: goal, start, planner_id, use_start.
inline Bytes compute_path_goal(const PoseStamped& goal, const std::string& planner) {
  CdrOut out;
  write(out, goal);
  write(out, PoseStamped{.header = {.stamp = {}, .frame = ""}, .pose = {}});
  out.text(planner).number(std::uint8_t{0});
  return out.bytes();
}

/// nav2_msgs/action/FollowPath: path, controller_id, goal_checker_id, progress_checker_id.
inline Bytes follow_path_goal(const Path& path, const std::string& controller) {
  CdrOut out;
  write(out, path);
  out.text(controller).text("").text("");
  return out.bytes();
}

/// nav2_msgs/action/Spin: target_yaw [rad], time_allowance.
inline Bytes spin_goal(float yaw, std::int32_t seconds) {
  return CdrOut().number(yaw).number(seconds).number(std::uint32_t{0}).bytes();
}

/// nav2_msgs/action/BackUp: target [m], speed [m/s], time_allowance.
inline Bytes back_up_goal(double distance, float speed, std::int32_t seconds) {
  return CdrOut()
      .number(distance)
      .number(0.0)
      .number(0.0)
      .number(speed)
      .number(seconds)
      .number(std::uint32_t{0})
      .bytes();
}

/// nav2_msgs/action/Wait: time.
inline Bytes wait_goal(std::int32_t seconds) {
  return CdrOut().number(seconds).number(std::uint32_t{0}).bytes();
}

/// The end of every result in Jazzy.
struct Error {
  std::uint16_t code = 0;
  std::string text;
};

inline Error read_error(CdrIn& in) {
  Error error;
  error.code = in.number<std::uint16_t>();
  error.text = in.text();
  return error;
}

/// A response of get_result: int8 status, then the result.
struct Outcome {
  std::int8_t status = 0;  ///< action_msgs/GoalStatus: 4 succeeded, 5 canceled, 6 aborted
  Path path;               ///< of the planner alone
  Error error;
};

inline Outcome read_compute_path_result(const Bytes& response) {
  CdrIn in(response);
  Outcome outcome;
  outcome.status = in.number<std::int8_t>();
  outcome.path = read_path(in);
  in.number<std::int32_t>();  // planning_time
  in.number<std::uint32_t>();
  outcome.error = read_error(in);
  return outcome;
}

inline Outcome read_follow_path_result(const Bytes& response) {
  CdrIn in(response);
  Outcome outcome;
  outcome.status = in.number<std::int8_t>();
  in.number<std::uint8_t>();  // std_msgs/Empty
  outcome.error = read_error(in);
  return outcome;
}

/// Of spin, backup, wait and drive_on_heading: total_elapsed_time, then the error.
inline Outcome read_behavior_result(const Bytes& response) {
  CdrIn in(response);
  Outcome outcome;
  outcome.status = in.number<std::int8_t>();
  in.number<std::int32_t>();
  in.number<std::uint32_t>();
  outcome.error = read_error(in);
  return outcome;
}

}  // namespace nav2
