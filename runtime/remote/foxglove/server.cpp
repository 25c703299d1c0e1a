// Clients come, speak and go. What they ask is in server_reading.cpp, what they command in
// server_commands.cpp.
#include "runtime/remote/foxglove/server.hpp"

#include <algorithm>
#include <utility>

namespace bw::foxglove {
namespace {

/// Announcements of `announced` in batches; one at least.
template <class T>
std::vector<web::Frame> batches(const std::vector<T>& announced, std::size_t batch,
                                std::string (*op)(std::span<const T>)) {
  std::vector<web::Frame> frames;
  std::size_t at = 0;
  do {
    const std::size_t count = std::min(batch, announced.size() - at);
    frames.push_back(web::text_frame(op(std::span(announced).subspan(at, count))));
    at += count;
  } while (at < announced.size());
  return frames;
}

}  // namespace

Server::Server(web::SocketSender& sender, Robot& robot, ServerOptions options, Clock clock)
    : sender_(sender),
      robot_(robot),
      options_(std::move(options)),
      clock_(std::move(clock)),
      published_topics_(robot),
      commander_(options_.is_one_commander, options_.commander_release) {
  robot_.set_listener(this);
}

Server::~Server() {
  *self_ = nullptr;
  robot_.set_listener(nullptr);
}

Client* Server::find(web::ConnectionId id) {
  const auto found = clients_.find(id);
  return found == clients_.end() ? nullptr : &found->second;
}

void Server::say(const Client& client, Level level, const std::string& message, const std::string& id) {
  send(client, web::text_frame(status_op(level, message, id)));
}

void Server::send_to_all(const web::Frame& frame) {
  for (const auto& [id, client] : clients_) sender_.send(id, frame, {});
}

ServerInfo Server::info_for(const Client& client) const {
  ServerInfo info;
  info.name = options_.name;
  info.capabilities = {"parameters", "parametersSubscribe", "services", "connectionGraph", "time"};
  if (client.opening.read_only.empty()) info.capabilities.emplace_back("clientPublish");
  if (options_.assets) info.capabilities.emplace_back("assets");
  info.metadata = robot_.metadata();
  info.metadata["may_command"] = client.opening.read_only.empty() ? "true" : "false";
  info.session = options_.session;
  return info;
}

void Server::on_open(web::ConnectionId id, const web::Opening& opening) {
  Client& client = clients_[id];
  client.id = id;
  client.opening = opening;
  client.subprotocol = opening.subprotocol == kWebsocketV1 ? Subprotocol::websocket_v1 : Subprotocol::sdk_v1;
  send(client, web::text_frame(server_info_op(info_for(client))));
  for (const web::Frame& frame : channel_frames()) send(client, frame);
  for (const web::Frame& frame : service_frames()) send(client, frame);
  tell_time(client);
  for (const Notice& notice : notices_) say(client, notice.level, notice.message);
  if (!client.opening.read_only.empty())
    say(client, Level::info, "Read only: " + client.opening.read_only, kReadOnlyStatus);
  tell_commander(client);
}

void Server::on_text(web::ConnectionId id, std::string_view text) {
  Client* client = find(id);
  if (client == nullptr) return;
  const auto decoded = decode_text(text);
  if (const auto* error = std::get_if<ProtocolError>(&decoded))
    return say(*client, Level::error, "Not understood: " + error->message);
  std::visit([this, client](const auto& op) { handle(*client, op); }, std::get<TextOp>(decoded));
}

void Server::on_binary(web::ConnectionId id, std::span<const std::uint8_t> bytes) {
  Client* client = find(id);
  if (client == nullptr) return;
  const auto decoded = decode_binary(bytes, client->subprotocol);
  if (const auto* error = std::get_if<ProtocolError>(&decoded))
    return say(*client, Level::error, "Not understood: " + error->message);
  std::visit([this, client](const auto& op) { handle(*client, op); }, std::get<BinaryOp>(decoded));
}

void Server::on_close(web::ConnectionId id) {
  const auto found = clients_.find(id);
  if (found == clients_.end()) return;
  const Client client = std::move(found->second);
  clients_.erase(found);
  for (const auto& [subscription, channel] : client.subscriptions) {
    channels_.at(channel).subscriptions.erase(id);
    robot_.unsubscribe(channel);
  }
  for (const auto& [own_id, channel] : client.published) published_topics_.release(channel.topic);
  if (std::none_of(clients_.begin(), clients_.end(), [](const auto& c) { return c.second.graph != nullptr; }))
    graph_.reset();
  commander_.leave(id);
  tell_commander();
}

void Server::tick() {
  commander_.tick(clock_());
  tell_commander();
  for (auto& [id, client] : clients_) tell_time(client);
}

void Server::on_channels(const std::vector<Channel>& added, const std::vector<std::uint32_t>& removed) {
  std::vector<std::uint32_t> gone;
  for (const std::uint32_t id : removed) {
    const auto found = channels_.find(id);
    if (found == channels_.end()) continue;
    forget_subscriptions(found->second);
    channels_.erase(found);
    gone.push_back(id);
  }
  // Two channels of one topic at a time are an error to clients: the old one goes first.
  if (!gone.empty()) send_to_all(web::text_frame(unadvertise_op(gone)));
  std::vector<Channel> news;
  for (const Channel& channel : added) {
    const auto [known, is_new] = channels_.try_emplace(channel.id);
    known->second.channel = channel;
    if (is_new) news.push_back(channel);
  }
  channel_frames_.reset();
  if (news.empty()) return;
  for (const web::Frame& frame : batches(news, options_.batch, advertise_op)) send_to_all(frame);
}

void Server::forget_subscriptions(const Heard& heard) {
  for (const auto& [id, subscription] : heard.subscriptions)
    clients_.at(id).subscriptions.erase(subscription);
}

void Server::on_services(const std::vector<Service>& added, const std::vector<std::uint32_t>& removed) {
  std::vector<std::uint32_t> gone;
  for (const std::uint32_t id : removed) {
    if (services_.erase(id) > 0) gone.push_back(id);
  }
  if (!gone.empty()) send_to_all(web::text_frame(unadvertise_services_op(gone)));
  std::vector<Service> news;
  for (const Service& service : added) {
    if (services_.insert_or_assign(service.id, service).second) news.push_back(service);
  }
  service_frames_.reset();
  if (news.empty()) return;
  for (const web::Frame& frame : batches(news, options_.batch, advertise_services_op)) send_to_all(frame);
}

const std::vector<web::Frame>& Server::channel_frames() {
  if (!channel_frames_) {
    std::vector<Channel> all;
    for (const auto& [id, heard] : channels_) all.push_back(heard.channel);
    channel_frames_ = batches(all, options_.batch, advertise_op);
  }
  return *channel_frames_;
}

const std::vector<web::Frame>& Server::service_frames() {
  if (!service_frames_) {
    std::vector<Service> all;
    for (const auto& [id, service] : services_) all.push_back(service);
    service_frames_ = batches(all, options_.batch, advertise_services_op);
  }
  return *service_frames_;
}

void Server::on_status(int level, const std::string& message) {
  const Notice notice{static_cast<Level>(std::clamp(level, 0, 2)), message};
  notices_.push_back(notice);
  if (notices_.size() > options_.kept_notices) notices_.pop_front();
  send_to_all(web::text_frame(status_op(notice.level, notice.message)));
}

}  // namespace bw::foxglove
