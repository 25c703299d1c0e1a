// A path asked for by one of Nav2's actions: the question and the answer without their layouts.
#pragma once

#include <string>

#include <nav_msgs/msg/path.hpp>

#include "components/global_planner/adaptor/map_planner.hpp"
#include "components/model/nav2_error_codes.hpp"

namespace bw {

struct PathQuestion {
  RouteRequest route;
  std::string planner_id;  ///< empty: the only one there is
};

struct PathAnswer {
  bool is_found = false;
  nav_msgs::msg::Path path;
  /// When none is found: of compute_path_to_pose, or of compute_path_through_poses where only that has one.
  Nav2ErrorCode error = compute_path_error::kUnknown;
  std::string reason;  ///< one sentence, then
};

PathAnswer answer_question(MapPlanner& planner, PathQuestion question, Time now);

}  // namespace bw
