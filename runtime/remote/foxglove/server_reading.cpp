// What clients hear and ask: it changes nothing.
#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "runtime/remote/foxglove/server.hpp"

namespace bw::foxglove {
namespace {

/// Streams of data are channels, which are u32; beyond them is the time.
constexpr std::uint64_t kTimeStream = std::uint64_t{1} << 32;

/// Messages of different topics overtake each other on their way here: what goes back by less is no jump of
/// the robot's clock.
constexpr Duration kLeastJump = Duration::milliseconds(500);

/// Several complaints of one kind in one sentence.
std::string listed(const char* what, const std::vector<std::uint32_t>& ids) {
  constexpr std::size_t kMax = 8;
  const std::span<const std::uint32_t> first = std::span(ids).first(std::min(ids.size(), kMax));
  std::string text = fmt::format("{} {}", what, fmt::join(first, ", "));
  if (ids.size() > kMax) text += fmt::format(" and {} more", ids.size() - kMax);
  return text;
}

}  // namespace

void Server::handle(Client& client, const Subscribe& op) {
  std::vector<std::uint32_t> used, unknown, repeated;
  for (const Subscription& wanted : op.subscriptions) {
    const auto found = channels_.find(wanted.channel);
    if (client.subscriptions.contains(wanted.id)) {
      used.push_back(wanted.id);
    } else if (found == channels_.end()) {
      unknown.push_back(wanted.channel);
    } else if (found->second.subscriptions.contains(client.id)) {
      repeated.push_back(wanted.channel);
    } else {
      found->second.subscriptions[client.id] = wanted.id;
      client.subscriptions[wanted.id] = wanted.channel;
      robot_.subscribe(wanted.channel);
      replay_latched(client, found->second, wanted.id);
    }
  }
  if (!used.empty()) say(client, Level::error, listed("subscribe: ids in use already:", used));
  if (!unknown.empty()) say(client, Level::error, listed("subscribe: there are no channels", unknown));
  if (!repeated.empty())
    say(client, Level::warning,
        listed("subscribe: heard already, one subscription each: channels", repeated));
}

void Server::handle(Client& client, const Unsubscribe& op) {
  std::vector<std::uint32_t> unknown;
  for (const std::uint32_t id : op.subscriptions) {
    const auto found = client.subscriptions.find(id);
    if (found == client.subscriptions.end()) {
      unknown.push_back(id);
      continue;
    }
    const std::uint32_t channel = found->second;
    client.subscriptions.erase(found);
    channels_.at(channel).subscriptions.erase(client.id);
    robot_.unsubscribe(channel);
  }
  if (!unknown.empty())
    say(client, Level::warning, listed("unsubscribe: there are no subscriptions", unknown));
}

void Server::tell_time(Client& client) {
  if (!time_ || client.told_time == time_) return;
  const Time now = clock_();
  const bool is_later = client.told_time && *time_ > *client.told_time;
  if (is_later && now - client.told_at < options_.time_period) return;
  client.told_time = time_;
  client.told_at = now;
  sender_.send(client.id, web::binary_frame(time_bytes(*time_)), {web::Keep::Rule::newest, kTimeStream});
}

void Server::send_message(Client& client, std::uint32_t subscription, Time time, const SharedBytes& cdr,
                          web::Keep keep) {
  tell_time(client);
  sender_.send(client.id, {.head = web::Head(message_head(subscription, time)), .body = cdr}, keep);
}

void Server::replay_latched(Client& client, const Heard& heard, std::uint32_t subscription) {
  if (!heard.channel.is_latched) return;
  for (const auto& [time, cdr] : robot_.latched(heard.channel.id))
    send_message(client, subscription, time, cdr, {});
}

void Server::on_message(std::uint32_t channel, Time received, const SharedBytes& cdr) {
  const auto found = channels_.find(channel);
  if (found == channels_.end()) return;
  const Heard& heard = found->second;
  // The newest of a channel stays whatever else is left out. Where several latch (/tf_static), the newest is
  // not the whole.
  web::Keep keep{web::Keep::Rule::newest, channel};
  if (heard.channel.is_latched && robot_.latched(channel).size() > 1) keep = {};
  for (const auto& [id, subscription] : heard.subscriptions)
    send_message(clients_.at(id), subscription, received, cdr, keep);
}

void Server::on_time(Time now) {
  const bool is_back = time_ && now < *time_;
  if (is_back && *time_ - now < kLeastJump) return;
  time_ = now;
  // Clients take a jump back for a seek and drop what they have: they hear of it at once, others with their
  // next message.
  if (!is_back) return;
  for (auto& [id, client] : clients_) tell_time(client);
}

void Server::handle(Client& client, const SubscribeConnectionGraph&) {
  if (client.graph != nullptr) return say(client, Level::warning, "subscribeConnectionGraph: told already");
  if (graph_ == nullptr) graph_ = std::make_shared<const ConnectionGraph>(robot_.graph());
  client.graph = graph_;
  send(client, web::text_frame(graph_update_op(difference({}, *graph_))));
}

void Server::handle(Client& client, const UnsubscribeConnectionGraph&) {
  if (client.graph == nullptr)
    return say(client, Level::warning, "unsubscribeConnectionGraph: not subscribed");
  client.graph.reset();
}

void Server::on_graph() {
  graph_.reset();
  std::map<const ConnectionGraph*, std::optional<web::Frame>>
      updates;  // most clients were told the same before
  for (auto& [id, client] : clients_) {
    if (client.graph == nullptr) continue;
    if (graph_ == nullptr) graph_ = std::make_shared<const ConnectionGraph>(robot_.graph());
    const auto [update, is_first] = updates.try_emplace(client.graph.get());
    if (is_first) {
      const GraphDifference news = difference(*client.graph, *graph_);
      if (!news.is_empty()) update->second = web::text_frame(graph_update_op(news));
    }
    client.graph = graph_;
    if (update->second) send(client, *update->second);
  }
}

void Server::handle(Client& client, const FetchAsset& op) {
  std::variant<Bytes, std::string> found =
      "assets are not served here; what a robot looks like is on its topics";
  if (options_.assets) found = options_.assets(op.uri);
  const auto* error = std::get_if<std::string>(&found);
  send(client, web::binary_frame(error != nullptr ? asset_error_bytes(op.request, *error)
                                                  : asset_bytes(op.request, std::get<Bytes>(found))));
}

void Server::handle(Client& client, const PlaybackControl&) {
  say(client, Level::error, "Playback control is not offered: this is a robot, not a recording");
}

}  // namespace bw::foxglove
