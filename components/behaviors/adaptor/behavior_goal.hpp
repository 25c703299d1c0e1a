// A goal of any of the four actions, told how it fares.
#pragma once

#include <string>
#include <utility>

#include "components/behaviors/behavior.hpp"
#include "components/messages/nav2_results.hpp"
#include "runtime/component.hpp"
#include "runtime/stamps.hpp"

namespace bw {

class BehaviorGoal {
 public:
  virtual ~BehaviorGoal() = default;
  virtual const GoalId& id() const = 0;
  virtual void feedback(const BehaviorStep& step) = 0;
  /// Succeeded or aborted, as the step says.
  virtual void end(const BehaviorStep& step, Time now) = 0;
  virtual void cancel(Time now) = 0;
};

/// `Messages` are those of behavior_messages.hpp for action A.
template <class A, class Messages>
class ActionGoal final : public BehaviorGoal {
 public:
  ActionGoal(GoalHandle<A> handle, Time accepted) : handle_(std::move(handle)), age_(accepted) {
    handle_.execute();
  }

  const GoalId& id() const override { return handle_.id(); }
  void feedback(const BehaviorStep& step) override {
    typename A::Feedback feedback;
    Messages::write(feedback, step);
    handle_.feedback(feedback);
  }
  void end(const BehaviorStep& step, Time now) override {
    const auto its = result(step.error, step.text, age_.at(now));
    step.state == BehaviorStep::State::succeeded ? handle_.succeed(its) : handle_.abort(its);
  }
  void cancel(Time now) override { handle_.canceled(result(BehaviorError::none, "", age_.at(now))); }

  static typename A::Result result(BehaviorError error, const std::string& text, Duration elapsed) {
    typename A::Result result;
    result.total_elapsed_time(to_message(elapsed));
    set_error(result, Messages::kCodes.of(error), text);
    return result;
  }

 private:
  GoalHandle<A> handle_;
  GoalAge age_;
};

}  // namespace bw
