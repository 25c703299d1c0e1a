// A behavior: a short motion, or none, that somebody asks for by its size. One goal is one object; it is
// stepped at a steady rate until it says how it ended.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "components/model/base_stop.hpp"
#include "components/model/planning.hpp"
#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw {

/// Why a goal was not reached. Each action of Nav2 has numbers of its own for these; some have none for some.
enum class BehaviorError { none, unknown, timeout, tf_error, collision_ahead, invalid_input };

/// What a behavior may look at.
struct BehaviorSituation {
  PlanningProblem problem;  ///< without a plan; `now` is always there
  std::string
      missing;         ///< what is needed to move and is not there, one sentence; empty: the problem is whole
  std::string unseen;  ///< what is needed to look ahead and is not there, one sentence
  std::optional<BaseStop> base_stop = std::nullopt;  ///< nothing: it obeys, or does not tell
};

struct BehaviorStep {
  enum class State { running, succeeded, failed };
  State state = State::running;
  BehaviorError error = BehaviorError::none;  ///< of a failure
  std::string text;                           ///< of a failure: one sentence
  std::optional<Twist2> command;  ///< zero at the end; nothing from a behavior that does not drive
  double traveled = 0.0;          ///< [m] or [rad] towards the target; a rotation has its sign
  Duration left;                  ///< of a wait
};

class Behavior {
 public:
  virtual ~Behavior() = default;
  /// Not called again once it ended.
  virtual BehaviorStep step(const BehaviorSituation& situation) = 0;
};

/// A motion begins and ends so.
inline bool is_at_rest(const Twist2& twist) {
  constexpr double kSpeed = 0.01;     // [m/s]
  constexpr double kTurnRate = 0.02;  // [rad/s]
  return std::abs(twist.v) < kSpeed && std::abs(twist.omega) < kTurnRate;
}

inline BehaviorStep failed(BehaviorError error, std::string text) {
  return {.state = BehaviorStep::State::failed, .error = error, .text = std::move(text)};
}

/// The age of a goal, which a clock that goes back stops for that moment.
class GoalAge {
 public:
  explicit GoalAge(Time accepted) : last_(accepted) {}
  Duration at(Time now) {
    if (now > last_) age_ = age_ + (now - last_);
    last_ = now;
    return age_;
  }

 private:
  Time last_;
  Duration age_;
};

}  // namespace bw
