// The navigator's words as messages, and for people. Pure conversions.
#pragma once

#include <bandwagon_msgs/msg/follow_request.hpp>
#include <bandwagon_msgs/msg/follow_status.hpp>
#include <bandwagon_msgs/msg/navigation_status.hpp>
#include <bandwagon_msgs/msg/plan_request.hpp>
#include <bandwagon_msgs/msg/plan_result.hpp>

#include "components/navigator/goal_messages.hpp"
#include "runtime/logger.hpp"

namespace bw {

/// The header's frame is map, its stamp now.
bandwagon_msgs::msg::PlanRequest to_message(const PlanOrder& order, const std_msgs::msg::Header& header);
bandwagon_msgs::msg::FollowRequest to_message(const FollowOrder& order, const std_msgs::msg::Header& header);
bandwagon_msgs::msg::NavigationStatus to_message(const GoalReport& report,
                                                 const std_msgs::msg::Header& header);

/// A status from outside the known ones reads as the last, a failure.
PlanAnswer from_message(const bandwagon_msgs::msg::PlanResult& message);
FollowReport from_message(const bandwagon_msgs::msg::FollowStatus& message);

/// One line for people; nothing for what is only told on the way.
void log(const GoalReport& report, const Logger& log);

}  // namespace bw
