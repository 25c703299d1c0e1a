// Where front ends of the navigator hand in their goals: the topic, the graph's own and the actions alike.
#pragma once

#include <cstdint>

#include "components/navigator/adaptor/goal_frames.hpp"
#include "components/navigator/goal_list.hpp"
#include "runtime/ports.hpp"

namespace bw {

class GoalDesk {
 public:
  virtual ~GoalDesk() = default;

  /// A good goal preempts what is in hand, a list too; another one is refused, and what is in hand goes on.
  /// Returns the id under which reports come, of both.
  virtual std::uint64_t take(const PlacedGoal& goal, const Tick& tick) = 0;
  /// Why no goal can be driven now, which take() refuses with.
  virtual GoalProblem hindrance(const Tick& tick) const = 0;
  /// Preempts likewise. Its first goal is taken up with the next settle().
  virtual void take_list(GoalListOptions options, const Tick& tick) = 0;
  /// Of what is in hand. It ends when the robot stands.
  virtual void cancel(const Tick& tick) = 0;
  /// Sends what came of all that, reports first.
  virtual void settle(const Tick& tick) = 0;
};

}  // namespace bw
