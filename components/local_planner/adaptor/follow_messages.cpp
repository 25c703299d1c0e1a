#include "components/local_planner/adaptor/follow_messages.hpp"

#include <fmt/format.h>

#include "components/messages/geometry.hpp"

namespace bw {

GoalTolerance goal_tolerance_of(const bandwagon_msgs::msg::FollowRequest& request) {
  GoalTolerance tolerance;
  if (request.xy_tolerance() > 0.0) tolerance.xy = request.xy_tolerance();
  if (request.yaw_tolerance() > 0.0) tolerance.yaw = request.yaw_tolerance();
  return tolerance;
}

std::string tolerance_complaint(const GoalTolerance& goal, const DrivingOptions& own) {
  if (own.xy_goal_tolerance <= goal.xy && own.yaw_goal_tolerance <= goal.yaw) return {};
  const GoalTolerance used = arrival_tolerance({.goal_tolerance = goal}, own);
  return fmt::format(
      "xy_goal_tolerance {:g} m and yaw_goal_tolerance {:g} rad must not exceed what the navigator calls reached, {:g} m "
      "and {:g} rad: {:g} m and {:g} rad are used",
      own.xy_goal_tolerance, own.yaw_goal_tolerance, goal.xy, goal.yaw, used.xy, used.yaw);
}

bandwagon_msgs::msg::FollowStatus to_follow_status(const PlanningResult& result, bool idle) {
  namespace follow = bandwagon_msgs::msg::FollowStatus_Constants;
  bandwagon_msgs::msg::FollowStatus status;
  if (idle) {
    status.status(follow::IDLE);
  } else if (result.status == PlanningStatus::ok) {
    status.status(follow::FOLLOWING);
  } else {
    status.status(result.status == PlanningStatus::infeasible ? follow::BLOCKED : follow::FAILED);
  }
  status.reason(idle ? "" : result.reason);
  status.command(to_twist_message(result.command));
  return status;
}

}  // namespace bw
