#include "runtime/host/action_end.hpp"

#include <utility>

#include <action_msgs/msg/goal_status_array.hpp>

#include "runtime/host/actor.hpp"
#include "runtime/host/runner.hpp"
#include "runtime/stamps.hpp"

namespace bw {

Duration ActionEnd::result_timeout(RosDistro distro) {
  return Duration::seconds(distro == RosDistro::humble ? 15.0 * 60.0 : 10.0);
}

ActionEnd::ActionEnd(Actor& owner, std::string declared, std::string resolved, const ActionType& action_type,
                     const Ends& its_ends, Duration keep_results)
    : name(std::move(declared)),
      action(std::move(resolved)),
      type(action_type),
      ends(its_ends),
      book_(keep_results) {
  actor = &owner;
}

ServicePort& ActionEnd::send_goal_port() { return *ends.send_goal; }
ServicePort& ActionEnd::cancel_goal_port() { return *ends.cancel_goal; }
ServicePort& ActionEnd::get_result_port() { return *ends.get_result; }

bool ActionEnd::offer(const GoalId& id, std::shared_ptr<const void> goal, Time now) {
  if (!actor->is_active()) return false;
  {
    const std::lock_guard lock(mutex_);
    if (!book_.accept(id, now)) return false;
    goals_[id] = std::move(goal);
    news_.push_back({.id = id, .is_cancel = false});
    publish_status(now);
  }
  runner->arrived(*this);
  return true;
}

CanceledGoals ActionEnd::cancel(const CancelRequest& request, Time now) {
  CanceledGoals canceled;
  {
    const std::lock_guard lock(mutex_);
    canceled = book_.cancel(request);
    for (const CanceledGoals::Goal& goal : canceled.goals)
      news_.push_back({.id = goal.id, .is_cancel = true});
    if (!canceled.goals.empty()) publish_status(now);
  }
  if (!canceled.goals.empty()) runner->arrived(*this);
  return canceled;
}

void ActionEnd::send_result(const GoalId& id, const RequestId& to, Time now) {
  std::vector<std::uint8_t> response;
  {
    const std::lock_guard lock(mutex_);
    book_.forget_old(now);
    const GoalBook::Goal* goal = book_.find(id);
    if (goal != nullptr && !is_final(goal->status)) {
      awaited_[id].push_back(to);
      return;
    }
    response = goal != nullptr ? goal->result : handler.abandoned(GoalStatus::unknown, "");
  }
  ends.get_result->reply(to, response);
}

bool ActionEnd::take_one(Time now, std::optional<Duration>) {
  News news;
  std::shared_ptr<const void> goal;
  {
    const std::lock_guard lock(mutex_);
    if (news_.empty()) return false;
    news = news_.front();
    news_.pop_front();
    if (!book_.is_open(news.id)) return true;
    goal = goals_.at(news.id);
  }
  ended_.clear();
  if (!actor->is_active()) {
    abandon(actor->not_active(), now);
    return true;
  }
  const Tick tick{.now = now, .health = actor->health(now)};
  if (news.is_cancel) {
    handler.on_cancel(news.id, std::move(goal), tick);
  } else {
    handler.on_goal(news.id, std::move(goal), tick);
  }
  return true;
}

bool ActionEnd::is_open(const GoalId& id) const {
  if (ended_.contains(id)) return false;
  const std::lock_guard lock(mutex_);
  return book_.is_open(id);
}

bool ActionEnd::is_canceling(const GoalId& id) const {
  const std::lock_guard lock(mutex_);
  const GoalBook::Goal* goal = book_.find(id);
  return goal != nullptr && goal->status == GoalStatus::canceling;
}

void ActionEnd::execute(const GoalId& id) {
  runner->when_done([this, id] {
    const std::lock_guard lock(mutex_);
    if (book_.execute(id)) publish_status(runner->now());
  });
}

void ActionEnd::feedback(const GoalId& id, std::span<const std::uint8_t> cdr) {
  if (!is_open(id)) return;
  execute(id);
  ends.feedback->publish(cdr);
}

void ActionEnd::finish(const GoalId& id, GoalStatus how, std::vector<std::uint8_t> result) {
  if (!is_open(id)) return;
  ended_.insert(id);
  runner->when_done([this, id, how, bytes = std::move(result)]() mutable {
    const std::lock_guard lock(mutex_);
    end(id, how, std::move(bytes), runner->now());
  });
}

void ActionEnd::abandon(const std::string& reason, Time now) {
  const std::lock_guard lock(mutex_);
  for (const GoalId& id : book_.open())
    end(id, GoalStatus::aborted, handler.abandoned(GoalStatus::aborted, reason), now);
  news_.clear();
}

void ActionEnd::end(const GoalId& id, GoalStatus how, std::vector<std::uint8_t> result, Time now) {
  if (!book_.finish(id, how, result, now)) return;
  goals_.erase(id);
  publish_status(now);
  const auto waiting = awaited_.find(id);
  if (waiting == awaited_.end()) return;
  for (const RequestId& to : waiting->second) ends.get_result->reply(to, result);
  awaited_.erase(waiting);
}

void ActionEnd::publish_status(Time now) {
  book_.forget_old(now);
  action_msgs::msg::GoalStatusArray message;
  for (const GoalBook::Goal& goal : book_.goals()) {
    auto& one = message.status_list().emplace_back();
    one.goal_info().goal_id().uuid(goal.id);
    one.goal_info().stamp(to_stamp(goal.accepted));
    one.status(static_cast<std::int8_t>(goal.status));
  }
  std::vector<std::uint8_t> cdr;
  serialize(message, cdr);
  ends.status->publish(cdr);
}

}  // namespace bw
