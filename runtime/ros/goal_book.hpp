// The goals of one action server: who asked for what, where each stands, and the results that are still kept.
// States and answers as rcl_action has them. Not safe for two threads at a time.
#pragma once

#include <cstdint>
#include <vector>

#include "runtime/base/goal_status.hpp"
#include "runtime/base/time.hpp"
#include "runtime/ports.hpp"

namespace bw {

class GoalBook {
 public:
  /// More open goals than these are refused.
  static constexpr std::size_t kMaxOpen = 1000;

  struct Goal {
    GoalId id{};
    Time accepted;
    GoalStatus status = GoalStatus::accepted;
    Time ended;
    std::vector<std::uint8_t> result;  ///< of a goal that ended
  };
  /// Values of action_msgs/srv/CancelGoal.
  enum CancelCode : std::uint8_t { kNone = 0, kRejected = 1, kUnknownGoal = 2, kTerminated = 3 };

  /// Results are known so long after the end of their goals.
  explicit GoalBook(Duration keep_results) : keep_results_(keep_results) {}

  /// False: the id is known already, or too many goals are open.
  bool accept(const GoalId& id, Time now);
  /// Neither id nor stamp: every open goal. A stamp: all that were accepted until then. An id: that goal,
  /// beside a stamp that one too. What is being canceled already counts as ended.
  CanceledGoals cancel(const CancelRequest& request);
  /// False when the goal is not waiting to be executed.
  bool execute(const GoalId& id);
  /// A goal that nobody asked to cancel cannot end canceled: it is aborted then. False when it is not open.
  bool finish(const GoalId& id, GoalStatus end, std::vector<std::uint8_t> result, Time now);

  /// Null: never heard of, or forgotten.
  const Goal* find(const GoalId& id) const;
  bool is_open(const GoalId& id) const;
  std::vector<GoalId> open() const;
  /// In the order in which they were accepted.
  const std::vector<Goal>& goals() const { return goals_; }
  /// Forgets the goals whose results were kept long enough.
  void forget_old(Time now);

 private:
  Goal* lookup(const GoalId& id);

  Duration keep_results_;
  std::vector<Goal> goals_;
};

}  // namespace bw
