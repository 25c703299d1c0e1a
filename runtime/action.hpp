// An action server as its component sees it: goals come and are canceled in callbacks, and end when the
// component says so.
// Requests are acknowledged, results kept and statuses told by the runtime.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <action_msgs/msg/goal_status_array.hpp>
#include <action_msgs/srv/cancel_goal.hpp>

#include "runtime/service.hpp"

namespace bw {

/// One goal. A copyable handle for the component's own callbacks; handles of one goal compare equal.
template <class A>
class GoalHandle {
 public:
  GoalHandle() = default;
  GoalHandle(ActionPort* port, const GoalId& id, std::shared_ptr<const typename A::Goal> goal)
      : port_(port), id_(id), goal_(std::move(goal)) {}

  explicit operator bool() const { return port_ != nullptr; }
  bool operator==(const GoalHandle& other) const { return port_ == other.port_ && id_ == other.id_; }

  const typename A::Goal& goal() const { return *goal_; }
  const GoalId& id() const { return id_; }
  /// It has not ended.
  bool is_open() const { return port_ != nullptr && port_->is_open(id_); }
  bool is_canceling() const { return port_ != nullptr && port_->is_canceling(id_); }

  /// From accepted to executing. The first feedback does it too.
  void execute() const { port_->execute(id_); }
  void feedback(const typename A::Feedback& feedback) const {
    typename A::FeedbackMessage message;
    message.goal_id().uuid(id_);
    message.feedback(feedback);
    std::vector<std::uint8_t> cdr;
    serialize(message, cdr);
    port_->feedback(id_, cdr);
  }
  // A goal ends once: the first of these counts.
  void succeed(const typename A::Result& result) const { finish(GoalStatus::succeeded, result); }
  void abort(const typename A::Result& result) const { finish(GoalStatus::aborted, result); }
  /// For a goal that is being canceled; one that is not ends aborted.
  void canceled(const typename A::Result& result) const { finish(GoalStatus::canceled, result); }

 private:
  void finish(GoalStatus end, const typename A::Result& result) const {
    const bool is_canceled = end == GoalStatus::canceled && !is_canceling();
    typename A::GetResult::Response response;
    response.status(static_cast<std::int8_t>(is_canceled ? GoalStatus::aborted : end));
    response.result(result);
    std::vector<std::uint8_t> cdr;
    serialize(response, cdr);
    port_->finish(id_, is_canceled ? GoalStatus::aborted : end, std::move(cdr));
  }

  ActionPort* port_ = nullptr;
  GoalId id_{};
  std::shared_ptr<const typename A::Goal> goal_;
};

/// What a component does with goals. Called between its other callbacks, in the order in which goals and
/// requests to cancel were accepted. A goal in hand when another one comes goes on until the component ends
/// it.
template <class A>
struct ActionCallbacks {
  std::function<void(const GoalHandle<A>& goal, const Tick& tick)> on_goal;
  /// The goal is `canceling` by now. The component says when it is over, and how.
  std::function<void(const GoalHandle<A>& goal, const Tick& tick)> on_cancel;
  /// The result of a goal that is open when the component is deactivated: it ends aborted. Captures nothing
  /// of the component.
  std::function<typename A::Result(const std::string& reason)> abandoned;
};

template <class A>
ActionType action_type() {
  const auto message = []<class M>(std::type_identity<M>) {
    return MessageType{MessageTraits<M>::ros_name, MessageTraits<M>::dds_name, MessageTraits<M>::type_hash};
  };
  return {.ros_name = A::ros_name,
          .send_goal = service_type<typename A::SendGoal>(),
          .cancel_goal = service_type<action_msgs::srv::CancelGoal>(),
          .get_result = service_type<typename A::GetResult>(),
          .feedback = message(std::type_identity<typename A::FeedbackMessage>{}),
          .status = message(std::type_identity<action_msgs::msg::GoalStatusArray>{})};
}

/// Requests of the wire, answered by `port`. Nothing of a component is in them.
template <class A>
RequestHandler send_goal_handler(ActionPort& port) {
  using SendGoal = typename A::SendGoal;
  return request_handler<SendGoal>(
      port.send_goal_port(),
      [&port](const typename SendGoal::Request& request, const Tick& tick) {
        typename SendGoal::Response response;
        response.accepted(port.offer(request.goal_id().uuid(),
                                     std::make_shared<typename A::Goal>(request.goal()), tick.now));
        response.stamp(to_stamp(tick.now));
        return response;
      },
      [](const std::string&) { return typename SendGoal::Response(); });
}

RequestHandler cancel_goal_handler(ActionPort& port);

template <class A>
RequestHandler get_result_handler(ActionPort& port) {
  RequestHandler handler;
  handler.handle = [&port](std::span<const std::uint8_t> cdr, const RequestId& from, const Tick& tick) {
    typename A::GetResult::Request request;
    if (!deserialize(cdr, request)) return false;
    port.send_result(request.goal_id().uuid(), from, tick.now);
    return true;
  };
  handler.empty = [](std::vector<std::uint8_t>& cdr) { serialize(typename A::GetResult::Response(), cdr); };
  return handler;
}

template <class A>
ActionHandler action_handler(ActionPort& port, ActionCallbacks<A> callbacks) {
  const auto on = [&port](std::function<void(const GoalHandle<A>&, const Tick&)> callback) {
    return [&port, callback = std::move(callback)](const GoalId& id, std::shared_ptr<const void> goal,
                                                   const Tick& tick) {
      callback({&port, id, std::static_pointer_cast<const typename A::Goal>(std::move(goal))}, tick);
    };
  };
  ActionHandler handler{.send_goal = send_goal_handler<A>(port),
                        .cancel_goal = cancel_goal_handler(port),
                        .get_result = get_result_handler<A>(port),
                        .abandoned = nullptr,
                        .on_goal = on(std::move(callbacks.on_goal)),
                        .on_cancel = on(std::move(callbacks.on_cancel))};
  handler.abandoned = [result = std::move(callbacks.abandoned)](GoalStatus status,
                                                                const std::string& reason) {
    typename A::GetResult::Response response;
    response.status(static_cast<std::int8_t>(status));
    if (status != GoalStatus::unknown) response.result(result(reason));
    std::vector<std::uint8_t> cdr;
    serialize(response, cdr);
    return cdr;
  };
  return handler;
}

}  // namespace bw
