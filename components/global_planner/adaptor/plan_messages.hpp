// The planner's result as a message.
#pragma once

#include <bandwagon_msgs/msg/plan_result.hpp>
#include <std_msgs/msg/header.hpp>

#include "components/global_planner/planner.hpp"
#include "components/messages/geometry.hpp"

namespace bw {

inline std::uint8_t to_code(PathStatus status) {
  namespace codes = bandwagon_msgs::msg::PlanResult_Constants;
  switch (status) {
    case PathStatus::ok:
      return codes::SUCCEEDED;
    case PathStatus::start_outside:
    case PathStatus::start_blocked:
      return codes::START_BLOCKED;
    case PathStatus::goal_outside:
    case PathStatus::goal_blocked:
      return codes::GOAL_BLOCKED;
    case PathStatus::disconnected:
      return codes::DISCONNECTED;
    case PathStatus::no_map:
      return codes::NO_MAP;
    case PathStatus::unplaced:
      return codes::FAILED;  // the transforms may be a moment late
    case PathStatus::bad_request:
      break;
  }
  return codes::BAD_REQUEST;
}

inline bandwagon_msgs::msg::PlanResult to_plan_result(const PathResult& result, std::uint64_t id,
                                                      const std_msgs::msg::Header& header) {
  bandwagon_msgs::msg::PlanResult message;
  message.header(header);
  message.id(id);
  message.status(to_code(result.status));
  message.reason(result.reason);
  message.path(to_path(header.frame_id(), from_stamp(header.stamp()), result.path));
  return message;
}

}  // namespace bw
