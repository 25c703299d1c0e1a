// What readers that come late would know at some time of a recording: the last message of each latched
// writer, and every transform of /tf_static.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "runtime/recording/bag/bag.hpp"
#include "runtime/recording/replay/played_topics.hpp"

namespace bw::replay {

struct LatchedMessage {
  std::size_t topic = 0;  ///< of the bag
  bag::Bytes cdr;
};

/// In the order of the recording. Reads only the topics that are latched, from the bag's beginning to `time`.
[[nodiscard]] std::vector<LatchedMessage> latched_before(
    const bag::Bag& recording, Time time, const std::vector<std::optional<PlayedTopic>>& played);

}  // namespace bw::replay
