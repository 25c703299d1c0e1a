// The actions of Nav2's planner_server, in the layout of the graph's ROS 2.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <nav_msgs/msg/path.hpp>

#include "components/global_planner/adaptor/map_planner.hpp"
#include "runtime/component.hpp"

namespace bw {

/// Offers compute_path_to_pose and compute_path_through_poses, answered in the callback that hears the goal.
/// What a path is found for is published by `show`. `planner` outlives the setup.
void offer_path_actions(Setup& setup, MapPlanner& planner,
                        std::function<void(const nav_msgs::msg::Path&)> show);

}  // namespace bw
