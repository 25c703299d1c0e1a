#include "components/navigator/adaptor/navigator_messages.hpp"

#include <algorithm>

#include "components/messages/geometry.hpp"

namespace bw {

bandwagon_msgs::msg::PlanRequest to_message(const PlanOrder& order, const std_msgs::msg::Header& header) {
  bandwagon_msgs::msg::PlanRequest message;
  message.header(header);
  message.id(order.id);
  message.goal().header(header);
  message.goal().pose(to_pose(order.X_MG));
  for (const Pose2& X_MV : order.via) {
    auto& via = message.via_poses().emplace_back();
    via.header(header);
    via.pose(to_pose(X_MV));
  }
  return message;
}

bandwagon_msgs::msg::FollowRequest to_message(const FollowOrder& order, const std_msgs::msg::Header& header) {
  bandwagon_msgs::msg::FollowRequest message;
  message.header(header);
  message.id(order.id);
  message.mode(static_cast<std::uint8_t>(order.mode));
  message.path(to_path(header.frame_id(), from_stamp(header.stamp()), order.path));
  message.xy_tolerance(order.tolerance.xy);
  message.yaw_tolerance(order.tolerance.yaw);
  return message;
}

bandwagon_msgs::msg::NavigationStatus to_message(const GoalReport& report,
                                                 const std_msgs::msg::Header& header) {
  bandwagon_msgs::msg::NavigationStatus message;
  message.header(header);
  message.goal_id(report.goal_id);
  message.status(static_cast<std::uint8_t>(report.status));
  message.reason(report.reason);
  message.goal().header(header);
  message.goal().pose(to_pose(report.X_MG));
  message.xy_tolerance(report.tolerance.xy);
  message.yaw_tolerance(report.tolerance.yaw);
  message.distance_remaining(report.distance_remaining);
  message.number_of_recoveries(report.recoveries);
  message.navigation_time(to_message(report.navigation_time));
  return message;
}

PlanAnswer from_message(const bandwagon_msgs::msg::PlanResult& message) {
  constexpr auto kLast = static_cast<std::uint8_t>(PlanOutcome::failed);
  return {message.id(), static_cast<PlanOutcome>(std::min(message.status(), kLast)), message.reason(),
          from_path(message.path()), message.error_code()};
}

FollowReport from_message(const bandwagon_msgs::msg::FollowStatus& message) {
  constexpr auto kLast = static_cast<std::uint8_t>(FollowState::failed);
  return {message.id(), static_cast<FollowState>(std::min(message.status(), kLast)), message.reason(),
          message.error_code()};
}

void log(const GoalReport& report, const Logger& log) {
  if (report.status == GoalStatus::succeeded) {
    log.info("goal {}: {} in {:.1f} s", report.goal_id, report.reason, report.navigation_time.to_seconds());
  } else if (report.status == GoalStatus::accepted && report.reason.empty()) {
    log.info("goal {}: to ({:.2f}, {:.2f}, {:.2f})", report.goal_id, report.X_MG.x, report.X_MG.y,
             report.X_MG.theta);
  } else if (report.status == GoalStatus::canceling) {
    return;  // its end says the same once the robot stands
  } else if (!report.reason.empty()) {
    log.warn("goal {}: {}", report.goal_id, report.reason);
  }
}

}  // namespace bw
