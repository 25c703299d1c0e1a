// What clients command: publishing and services.
#include <fmt/format.h>

#include "runtime/remote/foxglove/server.hpp"

namespace bw::foxglove {
namespace {

/// Beyond all channels, as the time's (server_reading.cpp).
constexpr std::uint64_t kCommanderStream = (std::uint64_t{1} << 32) + 1;

}  // namespace

std::optional<std::string> Server::take_command(const Client& client) {
  if (!client.opening.read_only.empty()) return "read only: " + client.opening.read_only;
  if (!commander_.take(client.id, clock_()))
    return fmt::format("{} commands the robot; it is another one's turn {:g} s after its last command",
                       clients_.at(*commander_.holder()).opening.peer,
                       options_.commander_release.to_seconds());
  tell_commander();
  return std::nullopt;
}

void Server::tell_commander() {
  if (commander_.holder() == told_commander_) return;
  told_commander_ = commander_.holder();
  for (const auto& [id, client] : clients_) {
    if (told_commander_)
      tell_commander(client);
    else
      sender_.send(id, web::text_frame(remove_status_op({kCommanderStatus})),
                   {web::Keep::Rule::latched, kCommanderStream});
  }
}

void Server::tell_commander(const Client& client) {
  if (!told_commander_) return;
  const bool is_own = told_commander_ == client.id;
  const bool is_refused = !is_own && commander_.is_one_at_a_time();
  const std::string message =
      is_own ? "You command the robot" : clients_.at(*told_commander_).opening.peer + " commands the robot";
  sender_.send(
      client.id,
      web::text_frame(status_op(is_refused ? Level::warning : Level::info, message, kCommanderStatus)),
      {web::Keep::Rule::latched, kCommanderStream});
}

void Server::handle(Client& client, const Advertise& op) {
  for (const ClientChannel& channel : op.channels) {
    std::optional<std::string> reason;
    if (!client.opening.read_only.empty()) {
      reason = take_command(client);
    } else if (client.published.contains(channel.id)) {
      reason = fmt::format("channel {} is in use already", channel.id);
    } else if (client.published.size() >= options_.most_channels) {
      reason = fmt::format("{} channels of this client are open already", options_.most_channels);
    } else if (channel.encoding != kCdr && channel.encoding != kJson) {
      reason = fmt::format("encoding \"{}\" is none of cdr, json", channel.encoding);
    } else {
      reason = published_topics_.acquire(channel.topic, channel.schema_name);
    }
    if (reason)
      say(client, Level::error, fmt::format("advertise {}: {}", channel.topic, *reason));
    else
      client.published[channel.id] = channel;
  }
}

void Server::handle(Client& client, const Unadvertise& op) {
  for (const std::uint32_t id : op.channels) {
    const auto found = client.published.find(id);
    if (found == client.published.end()) {
      say(client, Level::warning, fmt::format("unadvertise: there is no channel {}", id));
      continue;
    }
    published_topics_.release(found->second.topic);
    client.published.erase(found);
  }
}

void Server::handle(Client& client, const Publish& op) {
  const auto found = client.published.find(op.channel);
  if (found == client.published.end())
    return say(client, Level::error, fmt::format("publish: channel {} was not advertised", op.channel));
  const ClientChannel& channel = found->second;
  // Whoever may command at all stops the robot, whose turn it is or not.
  const bool is_stop = channel.topic.ends_with("/emergency_stop");
  std::optional<std::string> reason = is_stop ? std::nullopt : take_command(client);
  if (!reason) {
    const std::string_view text(reinterpret_cast<const char*>(op.payload.data()), op.payload.size());
    reason = channel.encoding == kJson ? robot_.publish_json(channel.topic, text)
                                       : robot_.publish(channel.topic, op.payload);
  }
  // With an id: ten refused messages a second are one line on the client's page.
  if (reason)
    say(client, Level::error, fmt::format("publish to {}: {}", channel.topic, *reason),
        "publish " + channel.topic);
}

std::optional<std::string> Server::refuse_call(const Client& client, const CallService& op) const {
  if (!services_.contains(op.service)) return fmt::format("there is no service {}", op.service);
  if (op.encoding != kCdr && op.encoding != kJson)
    return fmt::format("encoding \"{}\" is none of cdr, json", op.encoding.substr(0, 40));
  if (client.calls.contains({op.service, op.call}))
    return fmt::format("call {} is in flight already", op.call);
  if (client.calls.size() >= options_.most_calls)
    return fmt::format("{} calls are in flight already", options_.most_calls);
  return std::nullopt;
}

void Server::handle(Client& client, const CallService& op) {
  std::optional<std::string> reason = refuse_call(client, op);
  if (!reason && !only_asks(services_.at(op.service).type)) reason = take_command(client);
  if (reason) return send(client, web::text_frame(service_failure_op(op.service, op.call, *reason)));
  client.calls.insert({op.service, op.call});
  const bool is_json = op.encoding == kJson;
  Robot::Answer answer = [self = self_, id = client.id, service = op.service, call = op.call,
                          is_json](const std::variant<Bytes, std::string>& reply) {
    if (*self != nullptr) (*self)->answer_call(id, service, call, is_json ? kJson : kCdr, reply);
  };
  if (is_json)
    robot_.call_json(op.service, {reinterpret_cast<const char*>(op.payload.data()), op.payload.size()},
                     std::move(answer));
  else
    robot_.call(op.service, op.payload, std::move(answer));
}

void Server::answer_call(web::ConnectionId id, std::uint32_t service, std::uint32_t call,
                         std::string_view encoding, const std::variant<Bytes, std::string>& reply) {
  Client* client = find(id);
  if (client == nullptr || client->calls.erase({service, call}) == 0) return;
  if (const auto* error = std::get_if<std::string>(&reply))
    return send(*client, web::text_frame(service_failure_op(service, call, *error)));
  send(*client, web::binary_frame(service_response_bytes(service, call, encoding, std::get<Bytes>(reply))));
}

}  // namespace bw::foxglove
