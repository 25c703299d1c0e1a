// The planner's result as a message, and Nav2's code for it.
#pragma once

#include <bandwagon_msgs/msg/plan_result.hpp>
#include <std_msgs/msg/header.hpp>

#include "components/global_planner/planner.hpp"
#include "components/messages/geometry.hpp"
#include "components/model/nav2_error_codes.hpp"

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

/// Of compute_path_to_pose. A map that has not come yet is what Nav2 calls a costmap that is late: its tree
/// tries again then.
constexpr Nav2ErrorCode error_code_of(PathStatus status) {
  switch (status) {
    case PathStatus::ok:
      return kNoError;
    case PathStatus::no_map:
      return compute_path_error::kTimeout;
    case PathStatus::unplaced:
    case PathStatus::bad_request:
      return compute_path_error::kTfError;
    case PathStatus::start_outside:
      return compute_path_error::kStartOutsideMap;
    case PathStatus::goal_outside:
      return compute_path_error::kGoalOutsideMap;
    case PathStatus::start_blocked:
      return compute_path_error::kStartOccupied;
    case PathStatus::goal_blocked:
      return compute_path_error::kGoalOccupied;
    case PathStatus::disconnected:
      return compute_path_error::kNoValidPath;
  }
  return compute_path_error::kUnknown;
}

inline bandwagon_msgs::msg::PlanResult to_plan_result(const PathResult& result, std::uint64_t id,
                                                      const std_msgs::msg::Header& header) {
  bandwagon_msgs::msg::PlanResult message;
  message.header(header);
  message.id(id);
  message.status(to_code(result.status));
  message.reason(result.reason);
  message.error_code(error_code_of(result.status));
  message.path(to_path(header.frame_id(), from_stamp(header.stamp()), result.path));
  return message;
}

}  // namespace bw
