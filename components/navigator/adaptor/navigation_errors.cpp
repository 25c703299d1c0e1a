#include "components/navigator/adaptor/navigation_errors.hpp"

#include "components/model/nav2_error_codes.hpp"

namespace bw {
namespace {

/// What the navigator itself has codes for, of one action.
struct Codes {
  Nav2ErrorCode unknown;
  Nav2ErrorCode tf_error;
  Nav2ErrorCode behavior_tree;
};

Codes codes_of(NavigateAction action, RosDistro distro) {
  if (distro < RosDistro::kilted)
    return {compute_path_error::kUnknown, compute_path_error::kTfError, compute_path_error::kUnknown};
  if (action == NavigateAction::through_poses)
    return {navigate_through_poses_error::kUnknown, navigate_through_poses_error::kTfError,
            navigate_through_poses_error::kFailedToLoadBehaviorTree};
  return {navigate_to_pose_error::kUnknown, navigate_to_pose_error::kTfError,
          navigate_to_pose_error::kFailedToLoadBehaviorTree};
}

/// Those of the planner are of compute_path_to_pose.
Nav2ErrorCode code_of(GoalFault fault, NavigateAction action, RosDistro distro) {
  const Codes own = codes_of(action, distro);
  switch (fault) {
    case GoalFault::none:
    case GoalFault::preempted:
      return kNoError;
    case GoalFault::refused:
      return own.unknown;
    case GoalFault::no_poses:
      return action == NavigateAction::to_pose ? own.unknown
                                               : compute_path_through_poses_error::kNoViapointsGiven;
    case GoalFault::behavior_tree:
      return own.behavior_tree;
    case GoalFault::unplaced:
      return own.tf_error;
    case GoalFault::planner_silent:
      return compute_path_error::kTimeout;
    case GoalFault::planner_failed:
      return compute_path_error::kUnknown;
    case GoalFault::blocked:
      return follow_path_error::kPatienceExceeded;
    case GoalFault::base_stands:
    case GoalFault::no_progress:
      return follow_path_error::kFailedToMakeProgress;
    case GoalFault::controller_failed:
      return follow_path_error::kNoValidControl;
    case GoalFault::controller_silent:
      return follow_path_error::kControllerTimedOut;
  }
  return own.unknown;
}

}  // namespace

std::uint16_t error_code(const GoalReport& report, NavigateAction action, RosDistro distro) {
  const Nav2ErrorCode code =
      report.error_code != kNoError ? report.error_code : code_of(report.fault, action, distro);
  return action == NavigateAction::through_poses ? of_through_poses(code) : code;
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
