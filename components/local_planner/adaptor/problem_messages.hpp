// From tracks to the movers of a PlanningProblem, and from its result to the status that others wait for. Whatever is not finite is kept: the planner's own check
// refuses it by name.
#pragma once

#include <vector>

#include <bandwagon_msgs/msg/follow_status.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>

#include "components/model/planning.hpp"
#include "runtime/base/time.hpp"

namespace bw {

/// Moves every track from its stamp to `now` along its prediction. X_OF: pose of the message's frame in odom.
std::vector<Mover> to_movers(const bandwagon_msgs::msg::Tracks& message, const Pose2& X_OF, Time now);

/// Status, reason and command; header, id and distance are the caller's. `idle`: there was nothing to do.
bandwagon_msgs::msg::FollowStatus to_follow_status(const PlanningResult& result, bool idle);

}  // namespace bw
