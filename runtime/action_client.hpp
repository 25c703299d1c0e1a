// A client of an action: sends goals, hears how they fare, cancels them. Made of the client's half of three
// services and a topic, so that it needs nothing of the host.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <utility>

#include "runtime/action.hpp"
#include "runtime/goal_id.hpp"
#include "runtime/graph/qos.hpp"

namespace bw {

/// What becomes of a goal. Each is a callback of the component, and may be left out.
template <class A>
struct GoalCallbacks {
  /// Once; false too when nobody answered within the deadline.
  std::function<void(bool accepted, const Tick& tick)> on_acknowledged = nullptr;
  std::function<void(const typename A::Feedback& feedback, const Tick& tick)> on_feedback = nullptr;
  /// Once for an accepted goal. Without a result, and with status unknown: the server is gone, or knows
  /// nothing of it.
  std::function<void(GoalStatus status, const typename A::Result* result, const Tick& tick)> on_result =
      nullptr;
};

/// A copyable handle; valid from configure() on.
template <class A>
class ActionClient {
 public:
  using SendGoal = typename A::SendGoal;
  using GetResult = typename A::GetResult;
  using CancelGoal = action_msgs::srv::CancelGoal;

  ActionClient() = default;
  /// By a Setup.
  template <class Setup>
  static ActionClient declare(Setup& setup, const std::string& name, Need need) {
    ActionClient client;
    client.state_ = std::make_shared<State>();
    State& state = *client.state_;
    state.random.seed(setup.is_lockstep() ? setup.seed() : std::random_device{}());
    const std::string part = name + "/_action/";
    state.send_goal = setup.template client<SendGoal>(part + "send_goal", need);
    state.cancel_goal = setup.template client<CancelGoal>(part + "cancel_goal", need);
    state.get_result = setup.template client<GetResult>(part + "get_result", need);
    setup.template input<typename A::FeedbackMessage>(
        part + "feedback", Qos::standard(),
        [weak = std::weak_ptr<State>(client.state_)](const auto& message, const Tick& tick) {
          if (const auto its = weak.lock()) its->hear(message, tick);
        },
        Need::optional);
    return client;
  }

  /// A server is there.
  bool is_ready() const {
    return state_->send_goal.is_ready() && state_->cancel_goal.is_ready() && state_->get_result.is_ready();
  }
  /// `deadline` is for the acknowledgement.
  GoalId send(const typename A::Goal& goal, Duration deadline, GoalCallbacks<A> callbacks) const {
    const GoalId id = state_->new_id();
    state_->goals[id] = std::move(callbacks);
    typename SendGoal::Request request;
    request.goal_id().uuid(id);
    request.goal(goal);
    state_->send_goal.call(
        request, deadline,
        [state = state_, id](const typename SendGoal::Response* response, const Tick& tick) {
          acknowledge(state, id, response != nullptr && response->accepted(), tick);
        });
    return id;
  }
  /// Asks to cancel it. Its end comes as the result.
  void cancel(const GoalId& id) const {
    typename CancelGoal::Request request;
    request.goal_info().goal_id().uuid(id);
    state_->cancel_goal.call(request, kPatience, [](const typename CancelGoal::Response*, const Tick&) {});
  }
  /// Hears no more of it.
  void forget(const GoalId& id) const { state_->goals.erase(id); }

 private:
  /// A server that died says nothing: so often it is looked whether it is there.
  static constexpr Duration kPatience = Duration::milliseconds(5000);

  struct State {
    Client<SendGoal> send_goal;
    Client<CancelGoal> cancel_goal;
    Client<GetResult> get_result;
    std::mt19937_64 random;
    std::map<GoalId, GoalCallbacks<A>> goals;  ///< whose results are awaited

    GoalId new_id() {
      return new_goal_id([this] { return static_cast<std::uint8_t>(random() >> 56U); });
    }
    void hear(const typename A::FeedbackMessage& message, const Tick& tick) {
      const auto goal = goals.find(message.goal_id().uuid());
      if (goal == goals.end() || !goal->second.on_feedback) return;
      const auto callback = goal->second.on_feedback;  // which may forget the goal
      callback(message.feedback(), tick);
    }
  };

  static void acknowledge(const std::shared_ptr<State>& state, const GoalId& id, bool accepted,
                          const Tick& tick) {
    const auto goal = state->goals.find(id);
    if (goal == state->goals.end()) return;
    const auto callback = goal->second.on_acknowledged;
    if (accepted) {
      ask_result(state, id);
    } else {
      state->goals.erase(goal);
    }
    if (callback) callback(accepted, tick);
  }

  static void ask_result(const std::shared_ptr<State>& state, const GoalId& id) {
    typename GetResult::Request request;
    request.goal_id().uuid(id);
    state->get_result.call(
        request, kPatience, [state, id](const typename GetResult::Response* response, const Tick& tick) {
          const auto goal = state->goals.find(id);
          if (goal == state->goals.end()) return;
          if (response == nullptr && state->get_result.is_ready()) return ask_result(state, id);
          const auto callback = goal->second.on_result;
          state->goals.erase(goal);
          if (!callback) return;
          const GoalStatus status =
              response != nullptr ? static_cast<GoalStatus>(response->status()) : GoalStatus::unknown;
          callback(status, is_final(status) ? &response->result() : nullptr, tick);
        });
  }

  std::shared_ptr<State> state_;
};

}  // namespace bw
