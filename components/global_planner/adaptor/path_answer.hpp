// A path asked for by one of Nav2's actions: the question and the answer without their layouts.
#pragma once

#include <cstdint>
#include <string>

#include <nav_msgs/msg/path.hpp>

#include "components/global_planner/adaptor/map_planner.hpp"

namespace bw {

/// Error codes of both actions are a base and one of these.
enum class PathError : std::uint16_t {
  unknown = 0,
  invalid_planner = 1,
  tf_error = 2,
  start_outside_map = 3,
  goal_outside_map = 4,
  start_occupied = 5,
  goal_occupied = 6,
  timeout = 7,
  no_valid_path = 8,
  no_viapoints_given = 9,  ///< of compute_path_through_poses alone
};

struct PathQuestion {
  RouteRequest route;
  std::string planner_id;  ///< empty: the only one there is
};

struct PathAnswer {
  bool is_found = false;
  nav_msgs::msg::Path path;
  PathError error = PathError::unknown;  ///< when none is found
  std::string reason;                    ///< one sentence, then
};

PathAnswer answer_question(MapPlanner& planner, PathQuestion question, Time now);

}  // namespace bw
