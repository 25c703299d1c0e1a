// Between tracks and the movers of a PlanningProblem. Whatever is not finite in tracks is kept: the planner's own
// check refuses it by name.
#pragma once

#include <string>
#include <vector>

#include <bandwagon_msgs/msg/tracks.hpp>

#include "components/model/planning.hpp"
#include "runtime/base/time.hpp"

namespace bw {

/// Whether a track's confidence is from 0 to 1; one that is not counts as 1, a person.
bool tells_confidence(const bandwagon_msgs::msg::Track& track);

/// Moves every track from its stamp to `now` along its prediction. X_OF: pose of the message's frame in odom.
std::vector<Mover> to_movers(const bandwagon_msgs::msg::Tracks& message, const Pose2& X_OF, Time now);

/// Movers in `frame` as of `now`; their velocities' covariance is not known, and told as 0.
bandwagon_msgs::msg::Tracks to_message(const std::vector<Mover>& movers, const std::string& frame, Time now);

}  // namespace bw
