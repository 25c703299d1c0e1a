#include "runtime/cli/action_layout.hpp"

#include <array>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "runtime/ros/dds_names.hpp"
#include "runtime/wire/type_registry.hpp"

namespace bw::cli {
namespace {

constexpr std::string_view kFeedbackTopic = "/_action/feedback";
constexpr std::string_view kFeedbackSuffix = "_FeedbackMessage";

MessageType type_of(const TypeDescription& type) { return {type.ros_name, type.dds_name, type.type_hash}; }

/// /navigate_to_pose of rt/navigate_to_pose/_action/feedback; empty for other topics.
std::string action_of_feedback(const dds::Endpoint& end) {
  const std::string topic = ros_topic(end.topic);
  if (!end.topic.starts_with("rt/") || !topic.ends_with(kFeedbackTopic)) return {};
  if (!ros_type(end.type).ends_with(kFeedbackSuffix)) return {};
  return topic.substr(0, topic.size() - kFeedbackTopic.size());
}

/// Whether a server has this end: it reads requests, and writes replies and feedback.
bool is_server_end(const dds::Endpoint& end, const std::string& action) {
  const std::string part = action + "/_action/";
  if (end.is_writer) {
    return end.topic == reply_topic(part + "send_goal") || end.topic == reply_topic(part + "get_result") ||
           end.topic == dds_topic(part + "feedback");
  }
  return end.topic == request_topic(part + "send_goal") || end.topic == request_topic(part + "get_result");
}

}  // namespace

std::map<std::string, SeenAction> actions_among(const std::vector<dds::Endpoint>& endpoints) {
  std::map<std::string, SeenAction> actions;
  for (const dds::Endpoint& end : endpoints) {
    const std::string name = action_of_feedback(end);
    if (name.empty()) continue;
    SeenAction& action = actions[name];
    const std::string type = ros_type(end.type);
    action.type = type.substr(0, type.size() - kFeedbackSuffix.size());
    (end.is_writer ? action.servers : action.clients).push_back(end.guid);
  }
  for (auto& [name, action] : actions) {
    for (const dds::Endpoint& end : endpoints) {
      const std::string hash = type_hash_in(end.user_data);
      if (!hash.empty() && is_server_end(end, name)) action.hashes[ros_type(end.type)] = hash;
    }
  }
  return actions;
}

ServiceType ActionLayout::send_goal() const {
  return {.ros_name = send_goal_request->ros_name,
          .request = type_of(*send_goal_request),
          .response = type_of(*send_goal_response),
          .event = {}};
}

ServiceType ActionLayout::get_result() const {
  return {.ros_name = get_result_request->ros_name,
          .request = type_of(*get_result_request),
          .response = type_of(*get_result_response),
          .event = {}};
}

ActionLayout layout_of(const SeenAction& action, RosDistro distro) {
  const auto part = [&](const char* suffix) {
    const std::string name = action.type + suffix;
    if (find_type(name) == nullptr)
      throw std::runtime_error(action.type + ": this program does not know the type");
    const auto told = action.hashes.find(name);
    if (told == action.hashes.end()) return find_type(name, distro);
    const TypeDescription* const type = find_type(name, told->second);
    if (type == nullptr) {
      throw std::runtime_error(
          fmt::format("the server's {} has fields that this program does not know ({})", name, told->second));
    }
    return type;
  };
  return {.send_goal_request = part("_SendGoal_Request"),
          .send_goal_response = part("_SendGoal_Response"),
          .get_result_request = part("_GetResult_Request"),
          .get_result_response = part("_GetResult_Response"),
          .feedback = part("_FeedbackMessage")};
}

}  // namespace bw::cli
