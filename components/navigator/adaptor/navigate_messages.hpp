// Goals, feedback and results of the navigator's actions, whichever distribution lays them out.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "components/messages/geometry.hpp"
#include "components/messages/nav2_goals.hpp"
#include "components/messages/nav2_results.hpp"
#include "components/navigator/goal_list.hpp"
#include "components/navigator/goal_messages.hpp"

namespace bw {

/// One pose or several: all but the last are driven through.
template <class Goal>
std::vector<geometry_msgs::msg::PoseStamped> poses_of(const Goal& goal) {
  if constexpr (requires { goal.pose(); }) {
    return {goal.pose()};
  } else {
    return goal_poses(goal);
  }
}

inline geometry_msgs::msg::PoseStamped in_map(const Pose2& X_MP, const std_msgs::msg::Header& header) {
  geometry_msgs::msg::PoseStamped pose;
  pose.header(header);
  pose.pose(to_pose(X_MP));
  return pose;
}

/// From Kilted on navigate_through_poses tells of each of its poses whether it was passed; of those that were
/// not `rest` is said.
template <class Message>
void set_waypoint_statuses(Message& message, const std::vector<geometry_msgs::msg::PoseStamped>& poses,
                           std::size_t remaining, std::uint8_t rest) {
  if constexpr (requires { message.waypoint_statuses(); }) {
    constexpr std::uint8_t kCompleted = 1;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      auto& waypoint = message.waypoint_statuses().emplace_back();
      waypoint.waypoint_status(i + remaining < poses.size() ? kCompleted : rest);
      waypoint.waypoint_index(static_cast<std::uint32_t>(i));
      waypoint.waypoint_pose(poses[i]);
    }
  }
}

/// The report has a pose.
template <class Goal, class Feedback>
void set_feedback(Feedback& feedback, const Goal& goal, const GoalReport& report,
                  const std_msgs::msg::Header& header) {
  constexpr std::size_t kMax = std::numeric_limits<std::int16_t>::max();
  constexpr std::uint8_t kPending = 0;
  const auto count = [=](std::size_t n) { return static_cast<std::int16_t>(std::min(n, kMax)); };
  feedback.current_pose(in_map(*report.X_MB, header));
  feedback.navigation_time(to_message(report.navigation_time));
  feedback.estimated_time_remaining(to_message(report.estimated_time_remaining));
  feedback.number_of_recoveries(count(report.recoveries));
  feedback.distance_remaining(static_cast<float>(report.distance_remaining));
  if constexpr (requires { feedback.number_of_poses_remaining(); })
    feedback.number_of_poses_remaining(count(report.poses_remaining));
  if constexpr (requires { feedback.position_tracking_error(); }) {
    feedback.position_tracking_error(static_cast<float>(report.position_tracking_error));
    feedback.heading_tracking_error(static_cast<float>(report.heading_tracking_error));
  }
  if constexpr (requires { feedback.waypoint_statuses(); })
    set_waypoint_statuses(feedback, poses_of(goal), report.poses_remaining, kPending);
}

/// Of a goal that ended: error code 0 where nothing went wrong.
template <class Goal, class Result>
void set_result(Result& result, const Goal& goal, const GoalReport& report, std::uint16_t error_code) {
  constexpr std::uint8_t kCompleted = 1, kFailed = 3;
  const bool reached = report.status == GoalStatus::succeeded;
  set_error(result, error_code, reached ? std::string() : report.reason);
  if constexpr (requires { result.waypoint_statuses(); })
    set_waypoint_statuses(result, poses_of(goal), report.poses_remaining, reached ? kCompleted : kFailed);
}

}  // namespace bw
