// From requests to the goal of a PlanningProblem, and from its result to the status that others wait for.
#pragma once

#include <string>

#include <bandwagon_msgs/msg/follow_request.hpp>
#include <bandwagon_msgs/msg/follow_status.hpp>

#include "components/local_planner/driving.hpp"
#include "components/model/planning.hpp"

namespace bw {

/// Within what the goal of the request counts as reached; the usual figures where it names none.
GoalTolerance goal_tolerance_of(const bandwagon_msgs::msg::FollowRequest& request);

/// One sentence when tolerances of the planner's own would end the drive short of the goal and are not used;
/// empty otherwise.
std::string tolerance_complaint(const GoalTolerance& goal, const DrivingOptions& own);

/// Status, reason and command; header, id and distance are the caller's. `idle`: there was nothing to do.
bandwagon_msgs::msg::FollowStatus to_follow_status(const PlanningResult& result, bool idle);

}  // namespace bw
