// The navigator's words: what it is told, what it orders from the planners and what it reports. Poses are of
// base_link in map.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

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
};

/// Asks the global planner for a path from the robot to the goal.
struct PlanOrder {
  std::uint64_t id = 0;
  Pose2 X_MG;
};

enum class PlanOutcome : std::uint8_t {
  succeeded,
  start_blocked,
  goal_blocked,
  disconnected,
  no_map,
  bad_request
};

struct PlanAnswer {
  std::uint64_t id = 0;
  PlanOutcome outcome = PlanOutcome::succeeded;
  std::string reason;
  std::vector<Pose2> path;
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
};

/// What the navigator wants sent, in this order.
struct NavigatorActions {
  std::vector<GoalReport> reports;
  std::optional<FollowOrder> follow;
  std::optional<PlanOrder> plan;
};

}  // namespace bw
