// From tracks to the movers of a PlanningProblem, from requests to its goal, and from its result to the status that
// others wait for. Whatever is not finite in tracks is kept: the planner's own check refuses it by name.
#pragma once

#include <string>
#include <vector>

#include <bandwagon_msgs/msg/follow_request.hpp>
#include <bandwagon_msgs/msg/follow_status.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>

#include "components/local_planner/driving.hpp"
#include "components/model/planning.hpp"
#include "runtime/base/time.hpp"

namespace bw {

/// Whether a track's confidence is from 0 to 1; one that is not counts as 1, a person.
bool tells_confidence(const bandwagon_msgs::msg::Track& track);

/// Moves every track from its stamp to `now` along its prediction. X_OF: pose of the message's frame in odom.
std::vector<Mover> to_movers(const bandwagon_msgs::msg::Tracks& message, const Pose2& X_OF, Time now);

/// Within what the goal of the request counts as reached; the usual figures where it names none.
GoalTolerance goal_tolerance_of(const bandwagon_msgs::msg::FollowRequest& request);

/// One sentence when tolerances of the planner's own would end the drive short of the goal and are not used;
/// empty otherwise.
std::string tolerance_complaint(const GoalTolerance& goal, const DrivingOptions& own);

/// Status, reason and command; header, id and distance are the caller's. `idle`: there was nothing to do.
bandwagon_msgs::msg::FollowStatus to_follow_status(const PlanningResult& result, bool idle);

}  // namespace bw
