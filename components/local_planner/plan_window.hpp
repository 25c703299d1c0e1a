// The stretch of a global plan that a local planner works on: from the robot to a local goal some way ahead
// (book 7.4).
#pragma once

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

}  // namespace bw
