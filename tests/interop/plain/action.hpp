// What both ends of a ROS 2 action say, by the letter of rcl_action: three services and two topics under
// <action>/_action/.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tests/interop/plain/service.hpp"

namespace plain {

using GoalId = std::array<std::uint8_t, 16>;

/// A goal id that differs from that of every other number.
GoalId goal_id(std::uint32_t number);

enum class GoalStatus : std::int8_t { unknown, accepted, executing, canceling, succeeded, canceled, aborted };
enum class CancelCode : std::int8_t { none, rejected, unknown_goal_id, goal_terminated };

struct Stamp {
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;
  auto operator<=>(const Stamp&) const = default;
};

struct GoalInfo {
  GoalId id{};
  Stamp stamp;  ///< when it was accepted
  bool operator==(const GoalInfo&) const = default;
};

struct GoalState {
  GoalInfo info;
  GoalStatus status = GoalStatus::unknown;
};

/// Of pkg/action/Name. The hashes are RIHS01_..., or all empty where none is told.
struct ActionType {
  std::string name;  ///< nav2_msgs/action/NavigateToPose
  ServiceType send_goal, get_result, cancel_goal;
  std::string feedback_hash;
  std::string status_hash;
};

/// Hashes in hexadecimal.
struct ActionHashes {
  std::string send_goal_request, send_goal_response, get_result_request, get_result_response, feedback;
};
/// With the hashes of action_msgs, which are the same in every distribution; without `hashes` none is told.
ActionType action_type(const std::string& name, const std::optional<ActionHashes>& hashes = std::nullopt);

std::string feedback_topic(const std::string& action);
std::string status_topic(const std::string& action);
std::string feedback_type(const std::string& type);
inline constexpr const char* kStatusType = "action_msgs::msg::dds_::GoalStatusArray_";

EndOptions feedback_end(const std::string& action, const ActionType& type);
EndOptions status_end(const std::string& action, const ActionType& type);

void write(CdrOut& cdr, const GoalInfo& info);
GoalInfo read_goal_info(CdrIn& cdr);
std::vector<GoalState> read_status_list(const Bytes& bytes);
Bytes status_list(const std::vector<GoalState>& goals);

/// 16 bytes of id, then `fields`: bytes of a message of their own without the encapsulation. An id moves no
/// alignment.
Bytes with_goal_id(const GoalId& id, const Bytes& message);

}  // namespace plain
