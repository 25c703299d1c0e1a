#include "tests/interop/plain/action.hpp"

namespace plain {
namespace {

constexpr const char* kPrefix = "RIHS01_";
// Printed by Jazzy's generator; action_msgs has not changed since.
constexpr const char* kCancelRequestHash = "3d3c84653c1f96918086887e1dcb236faec88b81a5b14fd4cf4840065bcdf8af";
constexpr const char* kCancelResponseHash =
    "35e682cf3f510e83c70a82a4aac888496dedee56773bf9d8e5e0aa81f9e1c960";
constexpr const char* kStatusHash = "6c1684b00f177d37438febe6e709fc4e2b0d4248dca4854946f9ed8b30cda83e";

}  // namespace

GoalId goal_id(std::uint32_t number) {
  GoalId id{};
  id[0] = 0xb0;  // never the id of zeros, which means all
  for (std::size_t i = 0; i < 4; ++i) id[15 - i] = static_cast<std::uint8_t>(number >> (8 * i));
  return id;
}

ActionType action_type(const std::string& name, const std::optional<ActionHashes>& hashes) {
  const auto told = [&](const std::string& hash) { return hashes ? kPrefix + hash : std::string(); };
  const ActionHashes own = hashes.value_or(ActionHashes{});
  return {.name = name,
          .send_goal = {name + "_SendGoal", told(own.send_goal_request), told(own.send_goal_response)},
          .get_result = {name + "_GetResult", told(own.get_result_request), told(own.get_result_response)},
          .cancel_goal = {"action_msgs/srv/CancelGoal", told(kCancelRequestHash), told(kCancelResponseHash)},
          .feedback_hash = told(own.feedback),
          .status_hash = told(kStatusHash)};
}

std::string feedback_topic(const std::string& action) { return "rt" + action + "/_action/feedback"; }
std::string status_topic(const std::string& action) { return "rt" + action + "/_action/status"; }

std::string feedback_type(const std::string& type) {
  const std::size_t first = type.find('/'), second = type.rfind('/');
  return type.substr(0, first) + "::action::dds_::" + type.substr(second + 1) + "_FeedbackMessage_";
}

EndOptions feedback_end(const std::string& action, const ActionType& type) {
  return {.topic = feedback_topic(action), .type = feedback_type(type.name), .type_hash = type.feedback_hash};
}

EndOptions status_end(const std::string& action, const ActionType& type) {
  return {.topic = status_topic(action),
          .type = kStatusType,
          .type_hash = type.status_hash,
          .depth = 1,
          .is_latched = true};
}

void write(CdrOut& cdr, const GoalInfo& info) {
  cdr.octets(info.id).number(info.stamp.sec).number(info.stamp.nanosec);
}

GoalInfo read_goal_info(CdrIn& cdr) {
  GoalInfo info;
  std::copy_n(cdr.take(info.id.size()), info.id.size(), info.id.begin());
  info.stamp.sec = cdr.number<std::int32_t>();
  info.stamp.nanosec = cdr.number<std::uint32_t>();
  return info;
}

std::vector<GoalState> read_status_list(const Bytes& bytes) {
  CdrIn cdr(bytes);
  std::vector<GoalState> goals(cdr.number<std::uint32_t>());
  for (GoalState& goal : goals) {
    goal.info = read_goal_info(cdr);
    goal.status = static_cast<GoalStatus>(cdr.number<std::int8_t>());
  }
  return goals;
}

Bytes status_list(const std::vector<GoalState>& goals) {
  CdrOut cdr;
  cdr.number(static_cast<std::uint32_t>(goals.size()));
  for (const GoalState& goal : goals) {
    write(cdr, goal.info);
    cdr.number(static_cast<std::int8_t>(goal.status));
  }
  return cdr.bytes();
}

Bytes with_goal_id(const GoalId& id, const Bytes& message) {
  CdrOut cdr;
  cdr.octets(id);
  cdr.octets(Bytes(message.begin() + kEncapsulation, message.end()));
  return cdr.bytes();
}

}  // namespace plain
