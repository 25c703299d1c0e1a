#include "components/nav2_servers/drive_relay.hpp"

#include <algorithm>
#include <utility>

#include "components/model/nav2_error_codes.hpp"

namespace bw {
namespace {

/// Longer than controller_server tries before it gives up (failure_tolerance, 0.3 s as shipped).
constexpr Duration kTrial = Duration::milliseconds(500);

/// A robot that should stand and is still driven: so often its server is asked again.
constexpr Duration kCancelAgain = Duration::milliseconds(1000);

std::string name_of(FollowMode mode) {
  return mode == FollowMode::back_off ? "behavior_server" : "controller_server";
}

}  // namespace

std::string failure_sentence(const std::string& server, const ServerEnd& end) {
  if (end.status == GoalStatus::unknown) return server + " is gone";
  if (end.status == GoalStatus::canceled) return server + " was canceled by somebody else";
  if (!end.text.empty()) return server + ": " + end.text;
  if (end.error_code != 0) return server + " gave up with error code " + std::to_string(end.error_code);
  return server + " gave up";
}

void DriveRelay::order(std::uint64_t id, FollowMode mode) {
  order_id_ = id;
  is_doubted_ = mode == FollowMode::follow && mode_ == mode && state_ == FollowState::failed;
  mode_ = mode;
  current_ = 0;
  is_asked_ = false;
  if (is_doubted_) return;
  state_ = mode == FollowMode::stop ? FollowState::idle : FollowState::following;
  reason_.clear();
  error_code_ = 0;
}

void DriveRelay::acknowledged(std::uint64_t number, bool accepted) {
  const auto goal = open_.find(number);
  if (goal == open_.end()) return;
  goal->second.acknowledged = true;
  if (accepted) return;
  const FollowMode mode = goal->second.mode;
  open_.erase(goal);
  if (number == current_) fail(name_of(mode) + " does not take the goal");
}

void DriveRelay::ended(std::uint64_t number, const ServerEnd& end) {
  const auto goal = open_.find(number);
  if (goal == open_.end()) return;
  const FollowMode mode = goal->second.mode;
  open_.erase(goal);
  if (number != current_) return;
  if (end.status == GoalStatus::succeeded) {
    state_ = FollowState::reached;
    reason_.clear();
    error_code_ = 0;
    return;
  }
  clear_costmap_ = mode == FollowMode::follow && end.status == GoalStatus::aborted;
  fail(failure_sentence(name_of(mode), end), end.error_code);
}

void DriveRelay::fail(const std::string& reason, std::uint16_t error_code) {
  state_ = FollowState::failed;
  reason_ = reason;
  error_code_ = error_code;
}

bool DriveRelay::is_other_server_busy() const {
  return std::ranges::any_of(open_, [this](const auto& goal) { return goal.second.mode != mode_; });
}

RelayActions DriveRelay::step(const ServersReady& ready, Time now) {
  RelayActions actions;
  actions.clear_costmap = std::exchange(clear_costmap_, false);
  for (auto& [number, goal] : open_) {
    // A server may not know yet of a goal that it did not acknowledge, and would let it begin afterwards.
    if (goal.mode == mode_ || !goal.acknowledged) continue;
    if (goal.canceled && now >= *goal.canceled && now - *goal.canceled < kCancelAgain) continue;
    goal.canceled = now;
    actions.cancel.push_back(number);
  }
  if (const auto goal = open_.find(current_);
      is_doubted_ && goal != open_.end() && now - goal->second.sent >= kTrial) {
    is_doubted_ = false;
    state_ = FollowState::following;
    reason_.clear();
    error_code_ = 0;
  }
  if (mode_ == FollowMode::stop || is_asked_ || is_other_server_busy()) return actions;
  is_asked_ = true;
  if (!(mode_ == FollowMode::follow ? ready.follow_path : ready.back_up)) {
    fail("there is no " + name_of(mode_));
    return actions;
  }
  current_ = ++last_number_;
  open_[current_] = {.mode = mode_, .sent = now};
  actions.send = RelayGoal{current_, mode_};
  return actions;
}

RelayActions DriveRelay::stop() {
  order(order_id_, FollowMode::stop);
  RelayActions actions;
  for (const auto& [number, goal] : std::exchange(open_, {})) actions.cancel.push_back(number);
  return actions;
}

PlanOutcome outcome_of(std::uint16_t error_code) {
  namespace through = compute_path_through_poses_error;
  namespace to_pose = compute_path_error;
  switch (error_code) {
    case to_pose::kInvalidPlanner:
    case through::kInvalidPlanner:
    case through::kNoViapointsGiven:
      return PlanOutcome::bad_request;
    case to_pose::kStartOutsideMap:
    case to_pose::kStartOccupied:
    case through::kStartOutsideMap:
    case through::kStartOccupied:
      return PlanOutcome::start_blocked;
    case to_pose::kGoalOutsideMap:
    case to_pose::kGoalOccupied:
    case through::kGoalOutsideMap:
    case through::kGoalOccupied:
      return PlanOutcome::goal_blocked;
    case to_pose::kNoValidPath:
    case through::kNoValidPath:
      return PlanOutcome::disconnected;
    default:
      return PlanOutcome::failed;
  }
}

}  // namespace bw
