// Results and feedback of Nav2's actions and responses of its services, written and read without asking which
// layout it is. Where a layout lacks a field, writing it does nothing and reading it gives what Nav2 takes
// for granted without it.
#pragma once

#include <cstdint>
#include <string>
#include <type_traits>

#include <geometry_msgs/msg/pose_stamped.hpp>

namespace bw {

/// Humble's results have neither: what went wrong shows in the goal's status alone.
template <class Result>
void set_error(Result& result, std::uint16_t code, const std::string& text) {
  if constexpr (requires { result.error_code(code); }) {
    result.error_code(code);
    result.error_msg(text);
  }
}

/// 0 where there is none.
template <class Result>
std::uint16_t error_code_of(const Result& result) {
  if constexpr (requires { result.error_code(); }) return result.error_code();
  return 0;
}

/// Empty where there is none.
template <class Result>
std::string error_text_of(const Result& result) {
  if constexpr (requires { result.error_msg(); }) return result.error_msg();
  return {};
}

/// Lyrical's services say whether they could be served, older ones always could.
template <class Response>
void set_success(Response& response, bool success) {
  if constexpr (requires { response.success(success); }) response.success(success);
}

/// ComputePathThroughPoses, from Lyrical on: the last of the goals that the path reaches, -1 for all of
/// them. The message itself begins with 0.
template <class Result>
void set_last_reached_index(Result& result, std::int16_t index) {
  if constexpr (requires { result.last_reached_index(index); }) result.last_reached_index(index);
}

/// Of FollowWaypoints: int32 in Humble, MissedWaypoint in Jazzy, WaypointStatus (with status FAILED) from
/// Kilted on.
template <class Result>
void add_missed_waypoint(Result& result, std::uint32_t index, const geometry_msgs::msg::PoseStamped& pose,
                         std::uint16_t code, const std::string& text) {
  auto& missed = result.missed_waypoints().emplace_back();
  if constexpr (std::is_integral_v<std::remove_reference_t<decltype(missed)>>) {
    missed = static_cast<std::int32_t>(index);
  } else if constexpr (requires { missed.index(index); }) {
    missed.index(index);
    missed.goal(pose);
    missed.error_code(code);
  } else {
    constexpr std::uint8_t kFailed = 3;  // WaypointStatus::FAILED
    missed.waypoint_status(kFailed);
    missed.waypoint_index(index);
    missed.waypoint_pose(pose);
    set_error(missed, code, text);
  }
}

/// How the robot stands to the path it follows. Distances in m along the path, speed in m/s, errors from the
/// path in m (positive: left of it) and rad (positive: rotated to the right of it); the pose is base_link's,
/// in the path's frame.
struct PathTracking {
  geometry_msgs::msg::PoseStamped robot_pose;
  std::uint32_t path_index = 0;
  float distance_to_goal = 0.0F;
  float remaining_path_length = 0.0F;
  float speed = 0.0F;
  float position_error = 0.0F;
  float heading_error = 0.0F;
};

/// FollowPath: distance and speed up to Kilted, TrackingFeedback from Lyrical on.
template <class Feedback>
void set_tracking(Feedback& feedback, const PathTracking& tracking) {
  if constexpr (requires { feedback.tracking_feedback(); }) {
    auto& to = feedback.tracking_feedback();
    to.header(tracking.robot_pose.header());
    to.position_tracking_error(tracking.position_error);
    to.heading_tracking_error(tracking.heading_error);
    to.current_path_index(tracking.path_index);
    to.robot_pose(tracking.robot_pose);
    to.distance_to_goal(tracking.distance_to_goal);
    to.speed(tracking.speed);
    to.remaining_path_length(tracking.remaining_path_length);
  } else {
    feedback.distance_to_goal(tracking.distance_to_goal);
    feedback.speed(tracking.speed);
  }
}

}  // namespace bw
