#include "tests/interop/plain/action_server.hpp"

#include <algorithm>

namespace plain {
namespace {

GoalId id_in(const Bytes& request) {
  CdrIn cdr(request);
  GoalId id;
  std::copy_n(cdr.take(id.size()), id.size(), id.begin());
  return id;
}

bool is_cancelable(GoalStatus status) {
  return status == GoalStatus::accepted || status == GoalStatus::executing;
}

}  // namespace

ActionServer::ActionServer(Node& node, const std::string& action, const ActionType& type, Fields no_result)
    : node_(node),
      no_result_(std::move(no_result)),
      send_goal_(node, action + "/_action/send_goal", type.send_goal),
      cancel_goal_(node, action + "/_action/cancel_goal", type.cancel_goal),
      get_result_(node, action + "/_action/get_result", type.get_result),
      feedback_writer_(node.create_writer(feedback_end(action, type))),
      status_writer_(node.create_writer(status_end(action, type))) {
  node_.announce();
}

ActionServer::~ActionServer() {
  node_.remove(feedback_writer_);
  node_.remove(status_writer_);
}

void ActionServer::answer() {
  while (const auto request = send_goal_.take()) answer_goal(*request);
  while (const auto request = cancel_goal_.take()) answer_cancel(*request);
  while (const auto request = get_result_.take()) answer_result(*request);
}

ActionServer::Goal* ActionServer::find(const GoalId& id) {
  const auto found = std::ranges::find_if(goals_, [&](const Goal& goal) { return goal.state.info.id == id; });
  return found == goals_.end() ? nullptr : &*found;
}

void ActionServer::answer_goal(const Request& request) {
  const GoalId id = id_in(request.bytes);
  const bool is_accepted = find(id) == nullptr && accepts(request.bytes);
  const Stamp stamp{.sec = ++clock_};
  CdrOut cdr;
  cdr.number(static_cast<std::uint8_t>(is_accepted)).number(stamp.sec).number(stamp.nanosec);
  send_goal_.reply(request.from, cdr.bytes());
  if (!is_accepted) return;
  goals_.push_back({.state = {.info = {.id = id, .stamp = stamp}, .status = GoalStatus::accepted},
                    .bytes = request.bytes});
  publish_status();
}

void ActionServer::answer_cancel(const Request& request) {
  CdrIn cdr(request.bytes);
  const GoalInfo which = read_goal_info(cdr);
  const bool is_one = which.id != GoalId{} && which.stamp == Stamp{};
  const bool is_all = which == GoalInfo{};
  CancelCode code = is_one ? CancelCode::unknown_goal_id : CancelCode::none;
  std::vector<Goal*> named;
  for (Goal& goal : goals_) {
    const bool is_named = goal.state.info.id == which.id;
    if (is_one && is_named)
      code = is_cancelable(goal.state.status) ? CancelCode::none : CancelCode::goal_terminated;
    const bool is_meant = is_named || is_all || (!is_one && goal.state.info.stamp <= which.stamp);
    if (is_meant && is_cancelable(goal.state.status)) named.push_back(&goal);
  }
  if (!named.empty() && !grants_cancels) {
    code = CancelCode::rejected;
    named.clear();
  }
  CdrOut reply;
  reply.number(static_cast<std::int8_t>(code)).number(static_cast<std::uint32_t>(named.size()));
  for (Goal* goal : named) {
    goal->state.status = GoalStatus::canceling;
    write(reply, goal->state.info);
  }
  cancel_goal_.reply(request.from, reply.bytes());
  if (!named.empty()) publish_status();
}

void ActionServer::answer_result(const Request& request) {
  Goal* const goal = find(id_in(request.bytes));
  if (goal == nullptr) {
    CdrOut cdr;
    cdr.number(static_cast<std::int8_t>(GoalStatus::unknown));
    no_result_(cdr);
    get_result_.reply(request.from, cdr.bytes());
  } else if (goal->result) {
    get_result_.reply(request.from, *goal->result);
  } else {
    goal->waiting.push_back(request.from);
  }
}

void ActionServer::feedback(const GoalId& id, const Bytes& feedback) {
  Bytes bytes = with_goal_id(id, feedback);
  feedback_writer_->write(&bytes);
}

void ActionServer::finish(const GoalId& id, GoalStatus status, const Fields& result) {
  Goal* const goal = find(id);
  if (goal == nullptr) throw std::logic_error("no such goal");
  CdrOut cdr;
  cdr.number(static_cast<std::int8_t>(status));
  result(cdr);
  goal->result = cdr.bytes();
  set_status(id, status);
  for (const rtps::SampleIdentity& to : goal->waiting) get_result_.reply(to, *goal->result);
  goal->waiting.clear();
}

void ActionServer::set_status(const GoalId& id, GoalStatus status) {
  Goal* const goal = find(id);
  if (goal == nullptr) throw std::logic_error("no such goal");
  goal->state.status = status;
  publish_status();
}

void ActionServer::publish_status() {
  std::vector<GoalState> all;
  for (const Goal& goal : goals_) all.push_back(goal.state);
  Bytes bytes = status_list(all);
  status_writer_->write(&bytes);
}

}  // namespace plain
