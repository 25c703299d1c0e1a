// Parameters: asked, set and heard of.
#include <algorithm>

#include <fmt/format.h>

#include "runtime/remote/foxglove/server.hpp"

namespace bw::foxglove {

bool Server::begin_parameter_request(Client& client) {
  if (client.parameter_requests >= static_cast<int>(options_.most_calls)) {
    say(client, Level::error,
        fmt::format("{} requests for parameters are in flight already", options_.most_calls));
    return false;
  }
  ++client.parameter_requests;
  return true;
}

/// What is done with the robot's answer. Not asked for: only what went wrong is told.
Robot::Values Server::answer_parameters(const Client& client, const std::optional<std::string>& request,
                                        bool is_asked) {
  return [self = self_, id = client.id, request, is_asked](const std::vector<NamedValue>& values,
                                                           const std::vector<std::string>& errors) {
    Server* server = *self;
    if (server == nullptr) return;
    Client* asker = server->find(id);
    if (asker == nullptr) return;
    --asker->parameter_requests;
    for (const std::string& error : errors) server->say(*asker, Level::error, error);
    if (is_asked) server->send(*asker, web::text_frame(parameter_values_op(values, request)));
  };
}

void Server::handle(Client& client, const GetParameters& op) {
  if (begin_parameter_request(client))
    robot_.get_parameters(op.names, answer_parameters(client, op.request, true));
}

void Server::handle(Client& client, const SetParameters& op) {
  if (!begin_parameter_request(client)) return;
  if (const auto reason = take_command(client)) {
    say(client, Level::error, "setParameters: " + *reason);
    // The client shows what it asked for until it hears what holds.
    std::vector<std::string> names;
    for (const NamedValue& parameter : op.parameters) names.push_back(parameter.name);
    if (names.empty()) return static_cast<void>(--client.parameter_requests);
    return robot_.get_parameters(names, answer_parameters(client, op.request, true));
  }
  robot_.set_parameters(op.parameters, answer_parameters(client, op.request, op.request.has_value()));
}

void Server::handle(Client& client, const SubscribeParameterUpdates& op) {
  if (client.interest.add(op.names)) return;
  say(client, Level::error,
      fmt::format("subscribeParameterUpdates: more than {} names", ParameterInterest::kMaxNames));
}

void Server::handle(Client& client, const UnsubscribeParameterUpdates& op) {
  if (client.interest.remove(op.names)) return;
  say(client, Level::error,
      fmt::format("unsubscribeParameterUpdates: more than {} names", ParameterInterest::kMaxNames));
}

void Server::on_parameters(const std::vector<NamedValue>& changed) {
  std::optional<web::Frame> all;
  for (const auto& [id, client] : clients_) {
    if (client.interest.wants_all()) {
      if (!all) all = web::text_frame(parameter_values_op(changed, std::nullopt));
      send(client, *all);
      continue;
    }
    std::vector<NamedValue> wanted;
    std::copy_if(changed.begin(), changed.end(), std::back_inserter(wanted),
                 [&client](const NamedValue& value) { return client.interest.wants(value.name); });
    if (!wanted.empty()) send(client, web::text_frame(parameter_values_op(wanted, std::nullopt)));
  }
}

}  // namespace bw::foxglove
