// An action server whose goals do what their own text says, for tests of everything around it. The text is
// `behavior_tree` of NavigateToPose, `controller_id` of FollowPath:
//
//   succeed, abort   at once
//   wait             stays accepted until it is canceled
//   hold             executes until it is canceled
//   steps N          executes, one feedback at each tick, succeeds at tick N; canceled at once when asked
//   slow N           the same, but takes three ticks to be canceled
//   deaf N           the same, but goes on when it is asked to cancel
//
// Results have the code of Ending, where the layout has a place for it.
#pragma once

#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "components/messages/nav2_results.hpp"
#include "runtime/component.hpp"

namespace bw::test {

enum class Ending : std::uint16_t { as_told = 0, told_to_abort = 42, preempted = 43, abandoned = 44 };

enum class Policy {
  together,    ///< goals run side by side
  preempting,  ///< a new goal aborts the one before
};

template <class A>
class ScriptedActions {
 public:
  using Handle = GoalHandle<A>;

  static void offer(Setup& setup, const std::string& name, Policy policy,
                    Duration tick = Duration::milliseconds(20)) {
    auto self = std::make_shared<ScriptedActions>(policy);
    ActionCallbacks<A> callbacks;
    callbacks.on_goal = [self](const Handle& handle, const Tick&) { self->start(handle); };
    callbacks.on_cancel = [self](const Handle& handle, const Tick&) { self->cancel(handle); };
    callbacks.abandoned = [](const std::string& reason) { return result(Ending::abandoned, reason); };
    setup.action<A>(name, std::move(callbacks));
    setup.every(tick, name + " script", [self](const Tick&) { self->step(); });
  }

  explicit ScriptedActions(Policy policy) : policy_(policy) {}

 private:
  struct Goal {
    Handle handle;
    std::string word;
    int left = -1;         ///< ticks; -1: for ever
    int canceled_in = -1;  ///< ticks; -1: nobody asked
  };

  static typename A::Result result(Ending code, const std::string& text) {
    typename A::Result message;
    set_error(message, static_cast<std::uint16_t>(code), text);
    return message;
  }
  static const std::string& text_of(const typename A::Goal& goal) {
    if constexpr (requires { goal.behavior_tree(); }) {
      return goal.behavior_tree();
    } else {
      return goal.controller_id();
    }
  }

  void start(const Handle& handle) {
    if (policy_ == Policy::preempting) {
      for (const Goal& goal : goals_) goal.handle.abort(result(Ending::preempted, "another goal came"));
      goals_.clear();
    }
    Goal goal{.handle = handle};
    std::istringstream(text_of(handle.goal())) >> goal.word >> goal.left;
    if (goal.word == "hold" || goal.left == 0) goal.left = -1;
    if (goal.word == "succeed") return handle.succeed(result(Ending::as_told, ""));
    if (goal.word == "abort") return handle.abort(result(Ending::told_to_abort, "told to"));
    if (goal.word != "wait") handle.execute();
    goals_.push_back(goal);
  }

  void cancel(const Handle& handle) {
    for (Goal& goal : goals_) {
      if (!(goal.handle == handle) || goal.word == "deaf") continue;
      goal.canceled_in = goal.word == "slow" ? 3 : 0;
      if (goal.canceled_in == 0) handle.canceled(result(Ending::as_told, ""));
    }
    forget_ended();
  }

  void step() {
    for (Goal& goal : goals_) {
      if (goal.canceled_in > 0 && --goal.canceled_in == 0) {
        goal.handle.canceled(result(Ending::as_told, ""));
        continue;
      }
      if (goal.left < 0 || goal.word == "wait") continue;
      goal.handle.feedback(feedback(--goal.left));
      if (goal.left == 0) goal.handle.succeed(result(Ending::as_told, ""));
    }
    forget_ended();
  }

  static typename A::Feedback feedback(int left) {
    typename A::Feedback message;
    if constexpr (requires { message.distance_remaining(); }) {
      message.distance_remaining(static_cast<float>(left));
    } else if constexpr (requires { message.distance_to_goal(); }) {
      message.distance_to_goal(static_cast<float>(left));
    }
    return message;
  }

  void forget_ended() {
    std::erase_if(goals_, [](const Goal& goal) { return !goal.handle.is_open(); });
  }

  Policy policy_;
  std::vector<Goal> goals_;
};

}  // namespace bw::test
