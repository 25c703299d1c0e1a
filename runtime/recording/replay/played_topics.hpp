// Which topics of a bag are played, under which names, and what their writers offer.
#pragma once

#include <map>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "runtime/graph/qos.hpp"
#include "runtime/recording/bag/bag.hpp"

namespace bw::replay {

struct TopicSelection {
  std::vector<std::string> topics;                   ///< as recorded; empty: all
  std::optional<std::regex> exclude = std::nullopt;  ///< searched in recorded names
  std::map<std::string, std::string> remaps;         ///< recorded name to another
  bool without_clock = false;                        ///< not the recorded /clock: another one is published
};

struct PlayedTopic {
  std::string name;
  std::string type;
  std::string type_hash;
  Qos qos;
};

/// By topic of the bag; nothing for what is not played. Throws std::runtime_error for a topic or remap that
/// is not in the bag, a name that is none, two types on one topic, and when nothing is left.
[[nodiscard]] std::vector<std::optional<PlayedTopic>> played_topics(
    const std::vector<bag::BagTopic>& recorded, const TopicSelection& selection);

/// What a writer of the topic offers: what was recorded, else what is usual for its name and type.
[[nodiscard]] Qos playing_qos(const bag::BagTopic& topic);

}  // namespace bw::replay
