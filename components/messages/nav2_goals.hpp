// Goals of Nav2's actions, written and read without asking which layout it is. Where a layout lacks a field,
// reading it gives what Nav2 takes for granted without it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <geometry_msgs/msg/pose_stamped.hpp>
#include <nav_msgs/msg/goals.hpp>

namespace bw {

using PosesStamped = std::vector<geometry_msgs::msg::PoseStamped>;

namespace nav2_goals_detail {
inline const PosesStamped& poses_in(const PosesStamped& poses) { return poses; }
inline const PosesStamped& poses_in(const nav_msgs::msg::Goals& goals) { return goals.goals(); }
inline void put(PosesStamped poses, PosesStamped& into) { into = std::move(poses); }
inline void put(PosesStamped poses, nav_msgs::msg::Goals& into) {
  if (!poses.empty()) into.header(poses.front().header());
  into.goals(std::move(poses));
}
}  // namespace nav2_goals_detail

/// Of ComputePathThroughPoses, NavigateThroughPoses and FollowWaypoints: PoseStamped[] up to Jazzy,
/// nav_msgs/Goals from Kilted on.
template <class Goal>
const PosesStamped& goal_poses(const Goal& goal) {
  if constexpr (requires { goal.goals(); }) {
    return nav2_goals_detail::poses_in(goal.goals());
  } else {
    return nav2_goals_detail::poses_in(goal.poses());
  }
}

/// nav_msgs/Goals gets the header of the first pose.
template <class Goal>
void set_goal_poses(Goal& goal, PosesStamped poses) {
  if constexpr (requires { goal.goals(); }) {
    nav2_goals_detail::put(std::move(poses), goal.goals());
  } else {
    nav2_goals_detail::put(std::move(poses), goal.poses());
  }
}

/// ComputePathToPose, from Lyrical on: poses to pass on the way.
template <class Goal>
std::span<const geometry_msgs::msg::PoseStamped> via_points(const Goal& goal) {
  if constexpr (requires { goal.viapoints(); }) return goal.viapoints();
  return {};
}

/// FollowPath, from Jazzy on; empty for the only one there is.
template <class Goal>
std::string progress_checker_id(const Goal& goal) {
  if constexpr (requires { goal.progress_checker_id(); }) return goal.progress_checker_id();
  return {};
}

/// Spin, BackUp and DriveOnHeading, from Kilted on.
template <class Goal>
bool disables_collision_checks(const Goal& goal) {
  if constexpr (requires { goal.disable_collision_checks(); }) return goal.disable_collision_checks();
  return false;
}

/// FollowWaypoints, from Jazzy on: how often to begin again, and with which waypoint to begin at first.
template <class Goal>
std::uint32_t number_of_loops(const Goal& goal) {
  if constexpr (requires { goal.number_of_loops(); }) return goal.number_of_loops();
  return 0;
}
template <class Goal>
std::uint32_t first_waypoint(const Goal& goal) {
  if constexpr (requires { goal.goal_index(); }) return goal.goal_index();
  return 0;
}

}  // namespace bw
