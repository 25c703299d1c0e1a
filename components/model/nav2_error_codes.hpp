// Values of `error_code` in the results of Nav2's actions, from Jazzy on (Humble's results have no such
// field): the only place where they stand as numbers; nav2_error_codes.md says when each is given. Nav2's
// default tree clears a costmap and plans or follows once more after 100, 104, 105 and 106, and after 200,
// 207 and 208 or 300, 307 and 308; any other code ends the navigation at once. Codes are never renamed from
// one distribution to the next, only added: those that are younger than Jazzy say so, and mean nothing to an
// older client.
#pragma once

#include <cstdint>

namespace bw {

using Nav2ErrorCode = std::uint16_t;

inline constexpr Nav2ErrorCode kNoError = 0;
inline constexpr Nav2ErrorCode kGoalRejected = 1;     ///< lyrical; of every action
inline constexpr Nav2ErrorCode kSendGoalFailure = 2;  ///< lyrical; of every action

namespace follow_path_error {
inline constexpr Nav2ErrorCode kUnknown = 100;
inline constexpr Nav2ErrorCode kInvalidController = 101;
inline constexpr Nav2ErrorCode kTfError = 102;
inline constexpr Nav2ErrorCode kInvalidPath = 103;
inline constexpr Nav2ErrorCode kPatienceExceeded = 104;
inline constexpr Nav2ErrorCode kFailedToMakeProgress = 105;
inline constexpr Nav2ErrorCode kNoValidControl = 106;
inline constexpr Nav2ErrorCode kControllerTimedOut = 107;
inline constexpr Nav2ErrorCode kTimeout = 108;  ///< lyrical
}  // namespace follow_path_error

namespace compute_path_error {
inline constexpr Nav2ErrorCode kUnknown = 200;
inline constexpr Nav2ErrorCode kInvalidPlanner = 201;
inline constexpr Nav2ErrorCode kTfError = 202;
inline constexpr Nav2ErrorCode kStartOutsideMap = 203;
inline constexpr Nav2ErrorCode kGoalOutsideMap = 204;
inline constexpr Nav2ErrorCode kStartOccupied = 205;
inline constexpr Nav2ErrorCode kGoalOccupied = 206;
inline constexpr Nav2ErrorCode kTimeout = 207;
inline constexpr Nav2ErrorCode kNoValidPath = 208;
}  // namespace compute_path_error

namespace compute_path_through_poses_error {
inline constexpr Nav2ErrorCode kUnknown = 300;
inline constexpr Nav2ErrorCode kInvalidPlanner = 301;
inline constexpr Nav2ErrorCode kTfError = 302;
inline constexpr Nav2ErrorCode kStartOutsideMap = 303;
inline constexpr Nav2ErrorCode kGoalOutsideMap = 304;
inline constexpr Nav2ErrorCode kStartOccupied = 305;
inline constexpr Nav2ErrorCode kGoalOccupied = 306;
inline constexpr Nav2ErrorCode kTimeout = 307;
inline constexpr Nav2ErrorCode kNoValidPath = 308;
inline constexpr Nav2ErrorCode kNoViapointsGiven = 309;
}  // namespace compute_path_through_poses_error

/// What compute_path_through_poses calls it where compute_path_to_pose gives `code`. Any other code stays.
constexpr Nav2ErrorCode of_through_poses(Nav2ErrorCode code) {
  constexpr Nav2ErrorCode kShift = compute_path_through_poses_error::kUnknown - compute_path_error::kUnknown;
  const bool is_to_pose = code >= compute_path_error::kUnknown && code <= compute_path_error::kNoValidPath;
  return is_to_pose ? static_cast<Nav2ErrorCode>(code + kShift) : code;
}

namespace follow_waypoints_error {
inline constexpr Nav2ErrorCode kUnknown = 600;
inline constexpr Nav2ErrorCode kTaskExecutorFailed = 601;
inline constexpr Nav2ErrorCode kNoValidWaypoints = 602;      ///< kilted
inline constexpr Nav2ErrorCode kStopOnMissedWaypoint = 603;  ///< kilted
}  // namespace follow_waypoints_error

namespace spin_error {
inline constexpr Nav2ErrorCode kUnknown = 700;
inline constexpr Nav2ErrorCode kTimeout = 701;
inline constexpr Nav2ErrorCode kTfError = 702;
inline constexpr Nav2ErrorCode kCollisionAhead = 703;
}  // namespace spin_error

namespace back_up_error {
inline constexpr Nav2ErrorCode kUnknown = 710;
inline constexpr Nav2ErrorCode kTimeout = 711;
inline constexpr Nav2ErrorCode kTfError = 712;
inline constexpr Nav2ErrorCode kInvalidInput = 713;
inline constexpr Nav2ErrorCode kCollisionAhead = 714;
}  // namespace back_up_error

namespace drive_on_heading_error {
inline constexpr Nav2ErrorCode kUnknown = 720;
inline constexpr Nav2ErrorCode kTimeout = 721;
inline constexpr Nav2ErrorCode kTfError = 722;
inline constexpr Nav2ErrorCode kCollisionAhead = 723;
inline constexpr Nav2ErrorCode kInvalidInput = 724;
}  // namespace drive_on_heading_error

namespace wait_error {
inline constexpr Nav2ErrorCode kUnknown = 740;  ///< kilted
inline constexpr Nav2ErrorCode kTimeout = 741;  ///< kilted
}  // namespace wait_error

namespace navigate_to_pose_error {
inline constexpr Nav2ErrorCode kUnknown =
    9000;  ///< kilted; Jazzy hands on the code of the server that failed
inline constexpr Nav2ErrorCode kFailedToLoadBehaviorTree = 9001;  ///< kilted
inline constexpr Nav2ErrorCode kTfError = 9002;                   ///< kilted
inline constexpr Nav2ErrorCode kTimeout = 9003;                   ///< kilted
}  // namespace navigate_to_pose_error

namespace navigate_through_poses_error {
inline constexpr Nav2ErrorCode kUnknown =
    9100;  ///< kilted; Jazzy hands on the code of the server that failed
inline constexpr Nav2ErrorCode kFailedToLoadBehaviorTree = 9101;  ///< kilted
inline constexpr Nav2ErrorCode kTfError = 9102;                   ///< kilted
inline constexpr Nav2ErrorCode kTimeout = 9103;                   ///< kilted
}  // namespace navigate_through_poses_error

}  // namespace bw
