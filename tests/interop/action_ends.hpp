// The topics of an action as rcl_action has them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/interop/plain/action_server.hpp"

namespace bw::test {

struct ExpectedEnd {
  std::string topic, type, hash;
  bool is_writer = false, is_latched = false;
};

/// Of the server; the client has the opposites.
inline std::vector<ExpectedEnd> ends_of_server(const std::string& action, const plain::ActionType& type) {
  std::vector<ExpectedEnd> ends;
  const std::map<std::string, plain::ServiceType> services = {
      {"send_goal", type.send_goal}, {"get_result", type.get_result}, {"cancel_goal", type.cancel_goal}};
  for (const auto& [name, service] : services) {
    ends.push_back({.topic = "rq" + action + "/_action/" + name + "Request",
                    .type = plain::request_type(service.name),
                    .hash = service.request_hash});
    ends.push_back({.topic = "rr" + action + "/_action/" + name + "Reply",
                    .type = plain::response_type(service.name),
                    .hash = service.response_hash,
                    .is_writer = true});
  }
  ends.push_back({.topic = "rt" + action + "/_action/feedback",
                  .type = "nav2_msgs::action::dds_::NavigateToPose_FeedbackMessage_",
                  .hash = type.feedback_hash,
                  .is_writer = true});
  ends.push_back({.topic = "rt" + action + "/_action/status",
                  .type = "action_msgs::msg::dds_::GoalStatusArray_",
                  .hash = type.status_hash,
                  .is_writer = true,
                  .is_latched = true});
  return ends;
}

}  // namespace bw::test
