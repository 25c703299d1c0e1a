#include "runtime/host/command_watch.hpp"

#include <algorithm>
#include <utility>

#include <fmt/ranges.h>

#include "runtime/ros/dds_names.hpp"

namespace bw {
namespace {

constexpr Duration kPatience = Duration::milliseconds(1000);  // a node's name comes after its writer
constexpr std::size_t kMaxNames = 5;                          // in one line
constexpr const char* kNameless = "somebody without a node name";

bool is_owners(const dds::Endpoint& writer, const std::string& owner) {
  return std::ranges::find(writer.partitions, command_partition(owner)) != writer.partitions.end();
}

std::string listed(const std::vector<std::string>& names) {
  const std::size_t shown = std::min(names.size(), kMaxNames);
  std::string text =
      fmt::format("{}", fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown), ", "));
  if (shown < names.size()) text += fmt::format(" and {} more", names.size() - shown);
  return text;
}

}  // namespace

std::string command_partition(const std::string& owner) { return "commands_of:" + owner; }

CommandWatch::CommandWatch(const std::vector<WatchedTopic>& topics) {
  for (const WatchedTopic& topic : topics) watched_.push_back({.topic = topic, .strangers = {}});
}

std::vector<CommandWatch::News> CommandWatch::look(const std::vector<dds::Endpoint>& present,
                                                   const std::vector<dds::Endpoint>& departed,
                                                   const NodeOf& node_of, Time now, const Refuses& refuses) {
  std::vector<News> news;
  for (Watched& watched : watched_) {
    const WatchedTopic& topic = watched.topic;
    int owners = 0;
    for (auto& [guid, stranger] : watched.strangers) stranger.is_there = false;
    const auto meet = [&](const dds::Endpoint& end, bool is_there) {
      if (!end.is_writer || ros_topic(end.topic) != topic.topic) return;
      if (topic.owner.empty() && ros_type(end.type) == topic.type) return;
      if (!topic.owner.empty() && is_owners(end, topic.owner)) {
        owners += is_there ? 1 : 0;
        return;
      }
      const UnknownDevice stranger{.since = now, .type = ros_type(end.type)};
      watched.strangers.try_emplace(end.guid, stranger).first->second.is_there = is_there;
    };
    for (const dds::Endpoint& end : present) meet(end, true);
    for (const dds::Endpoint& end : departed) meet(end, false);
    if (const auto names = names_to_tell(watched, node_of, now); !names.empty())
      news.push_back({LogLevel::warn, refusal(topic, names)});
    std::erase_if(watched.strangers, [](const auto& item) { return !item.second.is_there; });
    watched.owners = owners;
    if (const auto told = news_of_owners(watched, refuses && refuses(topic.topic), now))
      news.push_back(*told);
  }
  return news;
}

std::optional<CommandWatch::News> CommandWatch::news_of_owners(Watched& watched, bool refuses, Time now) {
  constexpr Duration kForLong = Duration::milliseconds(2000);  // a successor is obeyed within one
  const WatchedTopic& topic = watched.topic;
  if (!refuses) watched.refused_since.reset();
  if (refuses && !watched.refused_since) watched.refused_since = now;
  const bool is_for_long = watched.refused_since && now - *watched.refused_since >= kForLong;
  if (is_for_long && !std::exchange(watched.is_refused, true))
    return News{
        LogLevel::error,
        fmt::format("nobody is obeyed on {} while two command: {} publishers are {}; the graph runs twice on "
                    "this domain",
                    topic.topic, watched.owners, topic.owner)};
  if (!refuses && std::exchange(watched.is_refused, false))
    return News{LogLevel::info, fmt::format("on {} one is obeyed again", topic.topic)};
  return std::nullopt;
}

/// Who has left is told with the name that is known.
std::vector<std::string> CommandWatch::names_to_tell(Watched& watched, const NodeOf& node_of, Time now) {
  std::vector<std::string> names;
  for (auto& [guid, stranger] : watched.strangers) {
    if (stranger.name.empty()) stranger.name = node_of(guid);
    const bool is_time = !stranger.name.empty() || !stranger.is_there || now - stranger.since >= kPatience;
    if (stranger.is_told || !is_time) continue;
    stranger.is_told = true;
    names.push_back(label(watched, stranger));
  }
  return names;
}

std::string CommandWatch::label(const Watched& watched, const UnknownDevice& stranger) {
  const std::string name = stranger.name.empty() ? kNameless : stranger.name;
  return watched.topic.owner.empty() ? name + " (" + stranger.type + ")" : name;
}

std::string CommandWatch::refusal(const WatchedTopic& topic, const std::vector<std::string>& names) {
  if (topic.owner.empty())
    return fmt::format("not heard: {}; {} is {} here", listed(names), topic.topic, topic.type);
  const std::string advice = topic.open.empty()
                                 ? "mark the input external: true in the graph to let others in"
                                 : fmt::format("others are heard on {}", fmt::join(topic.open, ", "));
  return fmt::format("refused: {} is commanded by {} alone; {} publish{} it too; {}", topic.topic,
                     topic.owner, listed(names), names.size() > 1 ? "" : "es", advice);
}

std::map<std::string, CommandWatch::State> CommandWatch::states() const {
  std::map<std::string, State> states;
  for (const Watched& watched : watched_) {
    const std::string& owner = watched.topic.owner;
    std::vector<std::string> names;
    for (const auto& [guid, stranger] : watched.strangers) {
      if (stranger.is_told) names.push_back(label(watched, stranger));
    }
    State& state = states[watched.topic.topic];
    if (watched.is_refused) {
      state = {LogLevel::error, fmt::format("nobody is obeyed while two command: {} publishers are {}",
                                            watched.owners, owner)};
    } else if (!names.empty()) {
      state = {LogLevel::warn, fmt::format("{}: {}", owner.empty() ? "not heard" : "refused", listed(names))};
    } else {
      state.text = owner.empty() ? "open to all" : "commanded by " + owner;
    }
  }
  return states;
}

bool CommandWatch::is_waiting() const {
  return std::ranges::any_of(watched_, [](const Watched& watched) {
    return watched.refused_since || watched.is_refused ||
           std::ranges::any_of(watched.strangers, [](const auto& item) { return !item.second.is_told; });
  });
}

}  // namespace bw
