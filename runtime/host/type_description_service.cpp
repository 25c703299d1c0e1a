#include "runtime/host/type_description_service.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <rcl_interfaces/msg/log.hpp>
#include <rcl_interfaces/msg/parameter_event.hpp>
#include <type_description_interfaces/srv/get_type_description.hpp>

#include "runtime/ros/type_description_messages.hpp"
#include "runtime/wire/type_registry.hpp"

namespace bw {
namespace {

using type_description_interfaces::srv::GetTypeDescription;
using Description = type_description_interfaces::msg::TypeDescription;

bool is_hash(const std::string& text) {
  constexpr std::string_view kVersion = "RIHS01_";
  constexpr std::size_t kDigits = 64;
  return text.starts_with(kVersion) && text.size() == kVersion.size() + kDigits &&
         text.find_first_not_of("0123456789abcdefABCDEF", kVersion.size()) == std::string::npos;
}

/// Null for a message that comes with a plugin: its description is not in this program.
const TypeDescription* known(const MessageType& type) { return find_type(type.ros_name, type.type_hash); }

std::vector<ServiceType> services_of(const Actor& actor) {
  std::vector<ServiceType> services;
  for (const auto& service : actor.services) services.push_back(service->type);
  for (const auto& client : actor.clients) services.push_back(client->type);
  return services;
}

template <class M>
MessageType message_type() {
  return {MessageTraits<M>::ros_name, MessageTraits<M>::dds_name, MessageTraits<M>::type_hash};
}

std::vector<MessageType> messages_of(const Actor& actor) {
  std::vector<MessageType> messages{message_type<rcl_interfaces::msg::Log>(),
                                    message_type<rcl_interfaces::msg::ParameterEvent>()};
  for (const auto& input : actor.inputs) messages.push_back(input->type);
  for (const auto& output : actor.outputs) messages.push_back(output->type);
  for (const ServiceType& service : services_of(actor))
    messages.insert(messages.end(), {service.request, service.response, service.event});
  return messages;
}

std::optional<Description> whole(const ServiceType& service) {
  const TypeDescription* const parts[] = {known(service.request), known(service.response),
                                          known(service.event)};
  if (std::ranges::find(parts, nullptr) != std::end(parts)) return std::nullopt;
  return join_parts(service.ros_name, {{"request_message", to_message(*parts[0])},
                                       {"response_message", to_message(*parts[1])},
                                       {"event_message", to_message(*parts[2])}});
}

/// Goal, result and feedback are the second fields of what carries them.
std::optional<Description> whole(const ActionType& action) {
  const TypeDescription* const carriers[] = {known(action.send_goal.request),
                                             known(action.get_result.response), known(action.feedback)};
  const auto send_goal = whole(action.send_goal);
  const auto get_result = whole(action.get_result);
  if (!send_goal || !get_result || carriers[2] == nullptr) return std::nullopt;
  return join_parts(action.ros_name, {{"goal", to_message(*carriers[0]->fields[1].message)},
                                      {"result", to_message(*carriers[1]->fields[1].message)},
                                      {"feedback", to_message(*carriers[2]->fields[1].message)},
                                      {"send_goal_service", *send_goal},
                                      {"get_result_service", *get_result},
                                      {"feedback_message", to_message(*carriers[2])}});
}

std::optional<Description> described(const Actor& actor, const std::string& hash) {
  for (const MessageType& message : messages_of(actor)) {
    if (message.type_hash != hash) continue;
    if (const TypeDescription* type = known(message)) return to_message(*type);
  }
  // The hash of a whole one is nowhere else: it is taken of what would be answered.
  const auto is_asked = [&](const auto& description) {
    return description && type_hash_of(*description) == hash;
  };
  for (const ServiceType& service : services_of(actor)) {
    if (auto description = whole(service); is_asked(description)) return description;
  }
  for (const auto& action : actor.actions) {
    if (auto description = whole(action->type); is_asked(description)) return description;
  }
  return std::nullopt;
}

}  // namespace

void offer_type_descriptions(Setup& setup, const Actor& actor) {
  setup.service<GetTypeDescription>(
      "~/get_type_description",
      [&actor](const GetTypeDescription::Request& request, const Tick&) {
        GetTypeDescription::Response response;
        const auto description = described(actor, request.type_hash());
        response.successful(description.has_value());
        if (description) {
          response.type_description(*description);
          if (request.include_type_sources()) response.type_sources(sources_of(*description));
        } else {
          response.failure_reason(is_hash(request.type_hash())
                                      ? "this node uses no type of that hash"
                                      : "type_hash is no hash: RIHS01_ and 64 hexadecimal digits");
        }
        return response;
      },
      nullptr, ServiceScope::node);
}

}  // namespace bw
