// Something that happens in a running graph, as the messages of one topic tell it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bw {

enum class EventRule { is, is_not, above, below, begins_with, rises };

/// One field of a message.
struct EventCondition {
  std::string
      field;  ///< header.frame_id, ranges[3]; with status[].name any element, the same one in all conditions
  EventRule rule = EventRule::is;
  std::string text{};                           ///< what it is compared with; nothing for `rises`
  std::optional<double> number = std::nullopt;  ///< the same as a number, where it is one
};

struct Event {
  std::string name;   ///< contact
  std::string topic;  ///< absolute
  /// All must hold in one message, and not have held in the one before. None: every message is an event.
  std::vector<EventCondition> when;
};

/// Names of the rules as graphs write them.
[[nodiscard]] std::string to_text(EventRule rule);
[[nodiscard]] std::optional<EventRule> event_rule_of(std::string_view text);

}  // namespace bw
