#include "runtime/recording/replay/played_topics.hpp"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "runtime/graph/names.hpp"
#include "runtime/parameters/nearest.hpp"
#include "runtime/recording/bag/known_type.hpp"
#include "runtime/recording/bag/qos_text.hpp"

namespace bw::replay {
namespace {

constexpr std::uint64_t kDeepest = 1000;  // samples that a late reader of /tf_static gets

void check_names(const std::vector<bag::BagTopic>& recorded, const TopicSelection& selection) {
  std::vector<std::string_view> known;
  for (const bag::BagTopic& topic : recorded) known.push_back(topic.name);
  const auto check = [&](const char* option, const std::string& name) {
    if (std::ranges::find(known, name) == known.end())
      throw std::runtime_error(std::string(option) + " " + name + ": " + unknown_rule("topic", name, known));
  };
  for (const std::string& name : selection.topics) check("--topics", name);
  for (const auto& [from, to] : selection.remaps) {
    check("--remap", from);
    if (const auto rule = topic_name_rule(to)) throw std::runtime_error("--remap " + to + ": " + *rule);
    if (!to.starts_with('/')) throw std::runtime_error("--remap " + to + ": must begin with /");
  }
}

/// One topic carries one type.
void check_types(const std::vector<std::optional<PlayedTopic>>& played) {
  std::map<std::string, std::string> types;
  for (const auto& topic : played) {
    if (!topic) continue;
    const std::string& first = types.emplace(topic->name, topic->type).first->second;
    if (first != topic->type) {
      throw std::runtime_error(topic->name + " was recorded as " + first + " and as " + topic->type +
                               ": play one of them elsewhere (--remap) or not at all (--exclude, --topics)");
    }
  }
}

std::string hash_of(const bag::BagTopic& topic) {
  if (!topic.type_hash.empty()) return topic.type_hash;
  const TypeDescription* ours = bag::known_type(topic).type;
  return ours == nullptr ? std::string() : std::string(ours->type_hash);
}

}  // namespace

Qos playing_qos(const bag::BagTopic& topic) {
  Qos qos = bag::playing_qos(bag::from_qos_text(topic.offered_qos_profiles));
  const bool is_static = topic.type == "tf2_msgs/msg/TFMessage" && topic.name.ends_with("tf_static");
  if (bag::from_qos_text(topic.offered_qos_profiles).empty()) {
    if (topic.name == "/rosout") return Qos::rosout();
    if (is_static) qos = Qos::tf_static();
    if (topic.type == "nav_msgs/msg/OccupancyGrid") qos = Qos::latched();
  }
  // Each of them may hold transforms that no other has.
  if (is_static)
    qos.depth = static_cast<int>(
        std::clamp<std::uint64_t>(topic.message_count, static_cast<std::uint64_t>(qos.depth), kDeepest));
  return qos;
}

std::vector<std::optional<PlayedTopic>> played_topics(const std::vector<bag::BagTopic>& recorded,
                                                      const TopicSelection& selection) {
  check_names(recorded, selection);
  const auto is_played = [&](const bag::BagTopic& topic) {
    if (topic.serialization_format != "cdr" || topic.type.find('/') == std::string::npos) return false;
    if (selection.without_clock && topic.name == "/clock") return false;
    if (selection.exclude && std::regex_search(topic.name, *selection.exclude)) return false;
    return selection.topics.empty() ||
           std::ranges::find(selection.topics, topic.name) != selection.topics.end();
  };
  std::vector<std::optional<PlayedTopic>> played;
  for (const bag::BagTopic& topic : recorded) {
    auto& entry = played.emplace_back();
    if (!is_played(topic)) continue;
    const auto remap = selection.remaps.find(topic.name);
    entry = PlayedTopic{.name = remap == selection.remaps.end() ? topic.name : remap->second,
                        .type = topic.type,
                        .type_hash = hash_of(topic),
                        .qos = playing_qos(topic)};
  }
  if (std::ranges::none_of(played, [](const auto& topic) { return topic.has_value(); }))
    throw std::runtime_error("nothing to play: the bag has no such topics of CDR messages");
  check_types(played);
  return played;
}

}  // namespace bw::replay
