// The services of Nav2's planner_server and of the global costmap inside it.
#pragma once

#include <functional>

#include <nav2_msgs/msg/costmap.hpp>
#include <nav_msgs/msg/path.hpp>

#include "components/global_planner/path_check.hpp"
#include "runtime/component.hpp"

namespace bw {

struct PlannerAnswers {
  std::function<PathCheck(const nav_msgs::msg::Path& path, Time now)> check;
  std::function<nav2_msgs::msg::Costmap(Time now)> costs;
};

/// Offers is_path_valid and, for the costs, global_costmap/get_costmap and the three clear services. There is nothing to
/// clear: costs follow from the map alone, and people who stand in the way are forgotten with each plan.
void offer_planner_services(Setup& setup, PlannerAnswers answers);

}  // namespace bw
