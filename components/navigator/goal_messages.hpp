// The navigator's words: what it is told, what it orders from the planners and what it reports. Poses are of
// base_link in map.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "components/model/base_stop.hpp"
#include "components/model/goal_tolerance.hpp"
#include "runtime/base/goal_status.hpp"
#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw {

/// What the robot knows of itself at a moment; no pose while localization is lost.
struct Situation {
  Time now;
  std::optional<Pose2> X_MB;
  Twist2 twist;
  double two_sigma = 0.0;             ///< of the position along its worst axis [m]; 0: nobody tells
  bool is_overridden = false;         ///< a hand has driven, and nobody has released it
  std::optional<BaseStop> base_stop;  ///< nothing: the base drives, or does not tell
};

/// Where to go.
struct NavigationGoal {
  Pose2 X_MG;
  std::vector<Pose2> via;  ///< to be passed before, in this order and without a stop
};

/// Why a goal was not reached, as far as programs care.
enum class GoalFault : std::uint8_t {
  none,
  refused,        ///< for what Nav2 has no code: too many poses, the navigator is deactivated
  no_poses,       ///< an empty list
  behavior_tree,  ///< asks for one by name, and there are none here
  unplaced,       ///< no pose, or in an unknown frame; the robot does not know where it is
  base_stands,    ///< the base stands and obeys nobody
  planner_silent,
  planner_failed,  ///< the planner's code tells more
  blocked,
  no_progress,
  controller_failed,
  controller_silent,
  preempted,
};

/// What went wrong, for people and for programs.
struct GoalProblem {
  GoalFault fault = GoalFault::none;
  std::string reason;            ///< one sentence
  std::uint16_t error_code = 0;  ///< of the server below that failed, where it gave one of Nav2's
};

/// Asks the global planner for a path from the robot through the via poses to the goal.
struct PlanOrder {
  std::uint64_t id = 0;
  Pose2 X_MG;
  std::vector<Pose2> via;
};

enum class PlanOutcome : std::uint8_t {
  succeeded,
  start_blocked,
  goal_blocked,
  disconnected,
  no_map,
  bad_request,
  failed  ///< whatever else; the next one may succeed
};

struct PlanAnswer {
  std::uint64_t id = 0;
  PlanOutcome outcome = PlanOutcome::succeeded;
  std::string reason;
  std::vector<Pose2> path;
  std::uint16_t error_code = 0;  ///< Nav2's, where the planner gave one
};

enum class FollowMode : std::uint8_t { stop, follow, back_off };

/// Tells the local planner what to do until the next order.
struct FollowOrder {
  std::uint64_t id = 0;
  FollowMode mode = FollowMode::stop;
  std::vector<Pose2> path;
  GoalTolerance tolerance;  ///< of the goal in hand
};

enum class FollowState : std::uint8_t { idle, following, blocked, reached, failed };

struct FollowReport {
  std::uint64_t id = 0;
  FollowState state = FollowState::idle;
  std::string reason;
  std::uint16_t error_code = 0;  ///< Nav2's, where the controller gave one
};

/// How a goal fares, for whoever set it.
struct GoalReport {
  std::uint64_t goal_id = 0;
  GoalStatus status = GoalStatus::accepted;
  std::string reason;  ///< one sentence; of a final status always there
  Pose2 X_MG;
  double distance_remaining = 0.0;  ///< along the path in use, else straight [m]
  std::uint32_t recoveries = 0;
  Duration navigation_time;
  GoalTolerance tolerance;  ///< within which the goal counts as reached
  GoalFault fault = GoalFault::none;
  std::uint16_t error_code = 0;          ///< of the server below that failed, where it gave one
  std::size_t poses_remaining = 1;       ///< the goal and the via poses that are not passed yet
  std::optional<Pose2> X_MB;             ///< where the robot is
  Duration estimated_time_remaining;     ///< at the speed of now; 0 while the robot stands
  double position_tracking_error = 0.0;  ///< from the path in use, left of it positive [m]
  double heading_tracking_error = 0.0;   ///< rotated to the right of it positive [rad]
};

/// What the navigator wants sent, in this order.
struct NavigatorActions {
  std::vector<GoalReport> reports;
  std::optional<FollowOrder> follow;
  std::optional<PlanOrder> plan;
};

}  // namespace bw
