// Nav2's error codes for what can go wrong with a goal. Whatever the server below said is handed on; what the
// navigator itself found has a code of its own from Kilted on, and before that the code of the server that
// would have found it.
#pragma once

#include <cstdint>

#include "components/navigator/goal_messages.hpp"
#include "runtime/base/ros_distro.hpp"

namespace bw {

enum class NavigateAction { to_pose, through_poses };

/// 0 for a goal that was reached, canceled or preempted.
std::uint16_t error_code(const GoalReport& report, NavigateAction action, RosDistro distro);

/// Of follow_waypoints, for a list without a first waypoint, and for one that ended at a missed one.
std::uint16_t no_waypoints_code(RosDistro distro);
std::uint16_t stopped_list_code(RosDistro distro);

}  // namespace bw
