// Nav2's actions and services as each distribution lays them out. Their names on the wire are the same
// everywhere, their fields are not (idl/README.md), so a server or client is made for the layout of the
// graph's `ros_distro`:
//
//   with_nav2_layout(setup.ros_distro(), [&](auto layout) {
//     using Nav2 = decltype(layout);
//     setup.action<typename Nav2::FollowPath>("follow_path", callbacks);
//   });
//
// Kilted and Lyrical follow the definitions of navigation2's branches and are unproved: no program of theirs
// has been met.
#pragma once

#include <utility>

#include <humble/nav2_msgs/action/back_up.hpp>
#include <humble/nav2_msgs/action/compute_path_through_poses.hpp>
#include <humble/nav2_msgs/action/compute_path_to_pose.hpp>
#include <humble/nav2_msgs/action/drive_on_heading.hpp>
#include <humble/nav2_msgs/action/follow_path.hpp>
#include <humble/nav2_msgs/action/follow_waypoints.hpp>
#include <humble/nav2_msgs/action/navigate_through_poses.hpp>
#include <humble/nav2_msgs/action/navigate_to_pose.hpp>
#include <humble/nav2_msgs/action/spin.hpp>
#include <humble/nav2_msgs/action/wait.hpp>
#include <kilted/nav2_msgs/action/back_up.hpp>
#include <kilted/nav2_msgs/action/compute_path_through_poses.hpp>
#include <kilted/nav2_msgs/action/drive_on_heading.hpp>
#include <kilted/nav2_msgs/action/follow_waypoints.hpp>
#include <kilted/nav2_msgs/action/navigate_through_poses.hpp>
#include <kilted/nav2_msgs/action/spin.hpp>
#include <kilted/nav2_msgs/srv/is_path_valid.hpp>
#include <lyrical/nav2_msgs/action/compute_path_through_poses.hpp>
#include <lyrical/nav2_msgs/action/compute_path_to_pose.hpp>
#include <lyrical/nav2_msgs/action/follow_path.hpp>
#include <lyrical/nav2_msgs/action/navigate_through_poses.hpp>
#include <lyrical/nav2_msgs/action/navigate_to_pose.hpp>
#include <lyrical/nav2_msgs/srv/clear_costmap_around_robot.hpp>
#include <lyrical/nav2_msgs/srv/clear_costmap_except_region.hpp>
#include <lyrical/nav2_msgs/srv/clear_entire_costmap.hpp>
#include <lyrical/nav2_msgs/srv/is_path_valid.hpp>
#include <nav2_msgs/action/back_up.hpp>
#include <nav2_msgs/action/compute_path_through_poses.hpp>
#include <nav2_msgs/action/compute_path_to_pose.hpp>
#include <nav2_msgs/action/drive_on_heading.hpp>
#include <nav2_msgs/action/follow_path.hpp>
#include <nav2_msgs/action/follow_waypoints.hpp>
#include <nav2_msgs/action/navigate_through_poses.hpp>
#include <nav2_msgs/action/navigate_to_pose.hpp>
#include <nav2_msgs/action/spin.hpp>
#include <nav2_msgs/action/wait.hpp>
#include <nav2_msgs/srv/clear_costmap_around_robot.hpp>
#include <nav2_msgs/srv/clear_costmap_except_region.hpp>
#include <nav2_msgs/srv/clear_entire_costmap.hpp>
#include <nav2_msgs/srv/is_path_valid.hpp>

#include "runtime/base/ros_distro.hpp"

namespace bw {

struct JazzyNav2 {
  using FollowPath = nav2_msgs::action::FollowPath;
  using ComputePathToPose = nav2_msgs::action::ComputePathToPose;
  using ComputePathThroughPoses = nav2_msgs::action::ComputePathThroughPoses;
  using NavigateToPose = nav2_msgs::action::NavigateToPose;
  using NavigateThroughPoses = nav2_msgs::action::NavigateThroughPoses;
  using FollowWaypoints = nav2_msgs::action::FollowWaypoints;
  using Spin = nav2_msgs::action::Spin;
  using BackUp = nav2_msgs::action::BackUp;
  using DriveOnHeading = nav2_msgs::action::DriveOnHeading;
  using Wait = nav2_msgs::action::Wait;
  using ClearEntireCostmap = nav2_msgs::srv::ClearEntireCostmap;
  using ClearCostmapAroundRobot = nav2_msgs::srv::ClearCostmapAroundRobot;
  using ClearCostmapExceptRegion = nav2_msgs::srv::ClearCostmapExceptRegion;
  using IsPathValid = nav2_msgs::srv::IsPathValid;
};

/// Its services are Jazzy's.
struct HumbleNav2 : JazzyNav2 {
  using FollowPath = humble::nav2_msgs::action::FollowPath;
  using ComputePathToPose = humble::nav2_msgs::action::ComputePathToPose;
  using ComputePathThroughPoses = humble::nav2_msgs::action::ComputePathThroughPoses;
  using NavigateToPose = humble::nav2_msgs::action::NavigateToPose;
  using NavigateThroughPoses = humble::nav2_msgs::action::NavigateThroughPoses;
  using FollowWaypoints = humble::nav2_msgs::action::FollowWaypoints;
  using Spin = humble::nav2_msgs::action::Spin;
  using BackUp = humble::nav2_msgs::action::BackUp;
  using DriveOnHeading = humble::nav2_msgs::action::DriveOnHeading;
  using Wait = humble::nav2_msgs::action::Wait;
};

/// What Kilted changed; the rest is Jazzy's.
struct KiltedNav2 : JazzyNav2 {
  using ComputePathThroughPoses = kilted::nav2_msgs::action::ComputePathThroughPoses;
  using NavigateThroughPoses = kilted::nav2_msgs::action::NavigateThroughPoses;
  using FollowWaypoints = kilted::nav2_msgs::action::FollowWaypoints;
  using Spin = kilted::nav2_msgs::action::Spin;
  using BackUp = kilted::nav2_msgs::action::BackUp;
  using DriveOnHeading = kilted::nav2_msgs::action::DriveOnHeading;
  using IsPathValid = kilted::nav2_msgs::srv::IsPathValid;
};

/// What Lyrical changed; the rest is Kilted's.
struct LyricalNav2 : KiltedNav2 {
  using FollowPath = lyrical::nav2_msgs::action::FollowPath;
  using ComputePathToPose = lyrical::nav2_msgs::action::ComputePathToPose;
  using ComputePathThroughPoses = lyrical::nav2_msgs::action::ComputePathThroughPoses;
  using NavigateToPose = lyrical::nav2_msgs::action::NavigateToPose;
  using NavigateThroughPoses = lyrical::nav2_msgs::action::NavigateThroughPoses;
  using ClearEntireCostmap = lyrical::nav2_msgs::srv::ClearEntireCostmap;
  using ClearCostmapAroundRobot = lyrical::nav2_msgs::srv::ClearCostmapAroundRobot;
  using ClearCostmapExceptRegion = lyrical::nav2_msgs::srv::ClearCostmapExceptRegion;
  using IsPathValid = lyrical::nav2_msgs::srv::IsPathValid;
};

/// Calls `f` with the layout of `distro`, an empty struct whose type is what counts; `automatic` is Jazzy's.
template <class F>
decltype(auto) with_nav2_layout(RosDistro distro, F&& f) {
  switch (distro) {
    case RosDistro::humble:
      return std::forward<F>(f)(HumbleNav2());
    case RosDistro::kilted:
      return std::forward<F>(f)(KiltedNav2());
    case RosDistro::lyrical:
      return std::forward<F>(f)(LyricalNav2());
    case RosDistro::automatic:
    case RosDistro::jazzy:
      break;
  }
  return std::forward<F>(f)(JazzyNav2());
}

}  // namespace bw
