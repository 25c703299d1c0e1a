#include "runtime/ros/goal_book.hpp"

#include <algorithm>
#include <utility>

namespace bw {

GoalBook::Goal* GoalBook::lookup(const GoalId& id) {
  const auto found = std::ranges::find(goals_, id, &Goal::id);
  return found == goals_.end() ? nullptr : &*found;
}

const GoalBook::Goal* GoalBook::find(const GoalId& id) const {
  const auto found = std::ranges::find(goals_, id, &Goal::id);
  return found == goals_.end() ? nullptr : &*found;
}

bool GoalBook::is_open(const GoalId& id) const {
  const Goal* goal = find(id);
  return goal != nullptr && !is_final(goal->status);
}

std::vector<GoalId> GoalBook::open() const {
  std::vector<GoalId> ids;
  for (const Goal& goal : goals_) {
    if (!is_final(goal.status)) ids.push_back(goal.id);
  }
  return ids;
}

bool GoalBook::accept(const GoalId& id, Time now) {
  if (find(id) != nullptr || open().size() >= kMaxOpen) return false;
  goals_.push_back({.id = id, .accepted = now, .status = GoalStatus::accepted, .ended = {}, .result = {}});
  return true;
}

CanceledGoals GoalBook::cancel(const CancelRequest& request) {
  const bool names_one = request.id != GoalId{};
  const bool names_time = request.stamp != Time{};
  const auto is_meant = [&](const Goal& goal) {
    if (names_one && goal.id == request.id) return true;
    return names_time ? goal.accepted <= request.stamp : !names_one;
  };
  CanceledGoals answer;
  for (Goal& goal : goals_) {
    const bool can_be = goal.status == GoalStatus::accepted || goal.status == GoalStatus::executing;
    if (!can_be || !is_meant(goal)) continue;
    goal.status = GoalStatus::canceling;
    answer.goals.push_back({goal.id, goal.accepted});
  }
  if (!names_one || names_time) return answer;
  if (find(request.id) == nullptr) {
    answer.code = kUnknownGoal;
  } else if (std::ranges::find(answer.goals, request.id, &CanceledGoals::Goal::id) == answer.goals.end()) {
    answer.code = kTerminated;
  }
  return answer;
}

bool GoalBook::execute(const GoalId& id) {
  Goal* goal = lookup(id);
  if (goal == nullptr || goal->status != GoalStatus::accepted) return false;
  goal->status = GoalStatus::executing;
  return true;
}

bool GoalBook::finish(const GoalId& id, GoalStatus end, std::vector<std::uint8_t> result, Time now) {
  Goal* goal = lookup(id);
  if (goal == nullptr || is_final(goal->status)) return false;
  const bool was_asked = goal->status == GoalStatus::canceling;
  goal->status = end == GoalStatus::canceled && !was_asked ? GoalStatus::aborted : end;
  goal->result = std::move(result);
  goal->ended = now;
  return true;
}

void GoalBook::forget_old(Time now) {
  std::erase_if(goals_,
                [&](const Goal& goal) { return is_final(goal.status) && now - goal.ended > keep_results_; });
}

}  // namespace bw
