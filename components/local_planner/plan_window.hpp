// The stretch of a global plan that a local planner works on: from the robot to a local goal some way ahead
// (book 7.4).
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "runtime/base/pose2.hpp"

namespace bw {

struct PlanWindow {
  std::vector<Pose2> poses;     ///< from near the robot to the local goal; empty when the plan is
  bool goal_is_final = true;    ///< the window ends where the plan ends
  double distance_to_goal = 0;  ///< along the plan, from the point nearest to the robot [m]
};

/// `start_hint` is the index where the robot was last on this plan (0 on a new one); it moves forward only,
/// so that a plan that crosses itself is followed in order.
PlanWindow plan_window(const std::vector<Pose2>& plan, const Pose2& robot, double lookahead,
                       std::size_t& start_hint);

/// A plan and how far the robot has come on it.
class FollowedPlan {
 public:
  /// A new plan, the robot at `index`; the distance to its goal is known from the next window() on.
  void start(std::vector<Pose2> plan, std::size_t index = 0) {
    plan_ = std::move(plan);
    index_ = index;
  }
  /// The stretch ahead of `robot` (in the plan's frame), about `lookahead` [m] long.
  const PlanWindow& window(const Pose2& robot, double lookahead) {
    return window_ = plan_window(plan_, robot, lookahead, index_);
  }
  /// [m], as of the last window.
  double distance_to_goal() const { return window_.distance_to_goal; }
  const std::vector<Pose2>& poses() const { return plan_; }
  /// Of the pose nearest to the robot, as of the last window.
  std::size_t index() const { return index_; }

 private:
  std::vector<Pose2> plan_;
  std::size_t index_ = 0;
  PlanWindow window_;
};

}  // namespace bw
