#include "components/navigator/adaptor/navigation_errors.hpp"

#include "components/messages/nav2_error_codes.hpp"

namespace bw {
namespace {

/// The codes of one action.
struct Codes {
  std::uint16_t unknown;
  std::uint16_t tf_error;
  std::uint16_t behavior_tree;
  int plan;  ///< added to the codes of compute_path_to_pose
};

Codes codes_of(NavigateAction action, RosDistro distro) {
  const bool through = action == NavigateAction::through_poses;
  const int plan = through ? compute_path_through_poses_error::kUnknown - compute_path_error::kUnknown : 0;
  if (distro < RosDistro::kilted) {
    const auto shifted = [plan](std::uint16_t code) { return static_cast<std::uint16_t>(code + plan); };
    return {shifted(compute_path_error::kUnknown), shifted(compute_path_error::kTfError),
            shifted(compute_path_error::kUnknown), plan};
  }
  if (through)
    return {navigate_through_poses_error::kUnknown, navigate_through_poses_error::kTfError,
            navigate_through_poses_error::kFailedToLoadBehaviorTree, plan};
  return {navigate_to_pose_error::kUnknown, navigate_to_pose_error::kTfError,
          navigate_to_pose_error::kFailedToLoadBehaviorTree, plan};
}

}  // namespace

std::uint16_t error_code(const GoalReport& report, NavigateAction action, RosDistro distro) {
  if (report.error_code != 0) return report.error_code;
  const Codes codes = codes_of(action, distro);
  const auto plan = [&](std::uint16_t code) { return static_cast<std::uint16_t>(code + codes.plan); };
  switch (report.fault) {
    case GoalFault::none:
    case GoalFault::preempted:
      return kNoError;
    case GoalFault::invalid_goal:
    case GoalFault::deactivated:
      return codes.unknown;
    case GoalFault::no_poses:
      return action == NavigateAction::to_pose ? codes.unknown
                                               : compute_path_through_poses_error::kNoViapointsGiven;
    case GoalFault::behavior_tree:
      return codes.behavior_tree;
    case GoalFault::unknown_frame:
    case GoalFault::lost:
      return codes.tf_error;
    case GoalFault::start_blocked:
      return plan(compute_path_error::kStartOccupied);
    case GoalFault::goal_blocked:
      return plan(compute_path_error::kGoalOccupied);
    case GoalFault::no_path:
      return plan(compute_path_error::kNoValidPath);
    case GoalFault::planner_silent:
      return plan(compute_path_error::kTimeout);
    case GoalFault::planner_failed:
      return plan(compute_path_error::kUnknown);
    case GoalFault::blocked:
      return follow_path_error::kPatienceExceeded;
    case GoalFault::no_progress:
      return follow_path_error::kFailedToMakeProgress;
    case GoalFault::controller_failed:
      return follow_path_error::kNoValidControl;
    case GoalFault::controller_silent:
      return follow_path_error::kControllerTimedOut;
  }
  return codes.unknown;
}

std::uint16_t no_waypoints_code(RosDistro distro) {
  return distro < RosDistro::kilted ? follow_waypoints_error::kUnknown
                                    : follow_waypoints_error::kNoValidWaypoints;
}

std::uint16_t stopped_list_code(RosDistro distro) {
  return distro < RosDistro::kilted ? follow_waypoints_error::kUnknown
                                    : follow_waypoints_error::kStopOnMissedWaypoint;
}

}  // namespace bw
