// Waiting: nothing is commanded, and nothing is needed.
#pragma once

#include "components/behaviors/behavior.hpp"

namespace bw {

class Wait final : public Behavior {
 public:
  /// 0 or less is over at once.
  Wait(Duration time, Time accepted) : time_(time), age_(accepted) {}

  BehaviorStep step(const BehaviorSituation& situation) override {
    const Duration left = time_ - age_.at(situation.problem.now);
    const bool is_over = left <= Duration{};
    return {.state = is_over ? BehaviorStep::State::succeeded : BehaviorStep::State::running, .left = left};
  }

 private:
  Duration time_;
  GoalAge age_;
};

}  // namespace bw
