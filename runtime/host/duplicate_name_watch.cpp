#include "runtime/host/duplicate_name_watch.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "runtime/graph/names.hpp"
#include "runtime/ros/dds_names.hpp"
#include "runtime/ros/node_directory.hpp"

namespace bw {
namespace {

constexpr std::size_t kMaxServices = 5;  // in one line
constexpr std::size_t kPrefixSize = 12;  // of a participant, in the ids of its ends

dds::Guid prefix_of(dds::Guid guid) {
  std::fill(guid.begin() + kPrefixSize, guid.end(), std::uint8_t{0});
  return guid;
}

/// The host's part of a prefix is the third and the fourth octet, behind the vendor's.
std::string location_of(const dds::Guid& theirs, const dds::Guid& ours) {
  const bool is_here = std::equal(theirs.begin(), theirs.begin() + 4, ours.begin());
  return fmt::format("participant {:02x} {}", fmt::join(theirs.begin(), theirs.begin() + kPrefixSize, "."),
                     is_here ? "of this machine" : "of another machine or vendor");
}

/// What a server is known by: an action by its own name, and once.
std::string served_name(const std::string& service) {
  const std::string_view name = without_action_part(service);
  return name == service || service.ends_with("/send_goal") ? std::string(name) : std::string();
}

std::string listed(const std::vector<std::string>& names) {
  const std::size_t shown = std::min(names.size(), kMaxServices);
  std::string text =
      fmt::format("{}", fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown), ", "));
  if (shown < names.size()) text += fmt::format(" and {} more", names.size() - shown);
  return text;
}

}  // namespace

DuplicateNameWatch::Rivals DuplicateNameWatch::rivals_in(const DomainView& view) const {
  const dds::Guid own = prefix_of(view.own_participant);
  Rivals rivals;
  for (const ParticipantEntities& participant : view.participants) {
    const dds::Guid prefix = prefix_of(participant.participant);
    if (prefix == own) continue;
    for (const NodeEntities& node : participant.nodes) {
      const auto ours = std::ranges::find(nodes_, full_name(node), &OwnNode::name);
      if (ours != nodes_.end()) rivals[{&*ours, prefix}] = {.node = ours->name, .is_duplicate = true};
    }
  }
  for (const dds::Endpoint& end : view.endpoints) {
    // Who reads requests is a server.
    const dds::Guid prefix = prefix_of(end.guid);
    if (end.is_writer || end.is_local || prefix == own) continue;
    const std::string service = service_of_request(end.topic);
    if (service.empty()) continue;
    for (const OwnNode& ours : nodes_) {
      if (std::ranges::find(ours.services, service) == ours.services.end()) continue;
      Rival& rival = rivals[{&ours, prefix}];
      if (rival.node.empty()) rival.node = view.node_of(end.guid);
      const std::string name = served_name(service);
      // What every node has says no more than its name.
      const bool is_private = name.starts_with(ours.name + "/");
      if (!name.empty() && !is_private && std::ranges::find(rival.services, name) == rival.services.end())
        rival.services.push_back(name);
    }
  }
  return rivals;
}

std::string DuplicateNameWatch::sentence(const OwnNode& ours, const dds::Guid& theirs, const Rival& rival,
                                         const dds::Guid& own_participant) {
  const std::string location = location_of(theirs, own_participant);
  const std::string served = rival.services.empty() ? "" : listed(rival.services);
  if (rival.is_duplicate || rival.services.empty())
    return fmt::format("{} is there twice: a node of {} has the same name{}", ours.name, location,
                       served.empty() ? "" : " and serves " + served + " too");
  return fmt::format("{} of {} is served twice: by {} of {} too", served, ours.name,
                     rival.node.empty() ? "somebody without a node name" : rival.node, location);
}

DuplicateNameWatch::News DuplicateNameWatch::news_of(std::string text) {
  return {LogLevel::error, std::move(text) + "; end one of the two: nobody can say which is asked"};
}

std::vector<DuplicateNameWatch::News> DuplicateNameWatch::look(const DomainView& view) {
  std::vector<News> news;
  Rivals now = rivals_in(view);
  for (auto& [key, rival] : now) {
    const auto before = rivals_.find(key);
    rival.looks = before == rivals_.end() ? 1 : before->second.looks + 1;
    if (rival.looks < 2 || told_.contains(key)) continue;
    told_[key] = sentence(*key.first, key.second, rival, view.own_participant);
    news.push_back(news_of(told_[key]));
  }
  rivals_ = std::move(now);
  std::erase_if(told_, [&](const auto& item) {
    const OwnNode& ours = *item.first.first;
    if (rivals_.contains(item.first)) return false;
    const bool is_last = std::ranges::none_of(rivals_, [&](const auto& r) { return r.first.first == &ours; });
    if (is_last) news.push_back({LogLevel::info, ours.name + " has no rival any more"});
    return true;
  });
  for (auto& [name, state] : states_) state = {LogLevel::info, "has no rival any more"};
  for (const auto& [key, text] : told_) states_[key.first->name] = news_of(text);
  return news;
}

std::string DuplicateNameWatch::rivals_of(const std::string& node, const DomainView& view) const {
  for (const auto& [key, rival] : rivals_in(view)) {
    const OwnNode& ours = *key.first;
    if (ours.name == node) return news_of(sentence(ours, key.second, rival, view.own_participant)).text;
  }
  return {};
}

bool DuplicateNameWatch::is_waiting() const {
  return std::ranges::any_of(rivals_, [](const auto& item) { return item.second.looks < 2; });
}

}  // namespace bw
