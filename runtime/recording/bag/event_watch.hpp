// Finds events in the messages that pass. Values in, result out.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "runtime/graph/event.hpp"
#include "runtime/recording/bag/bytes.hpp"
#include "runtime/wire/type_description.hpp"

namespace bw::bag {

/// What is wrong with a condition on messages of `type`, as a sentence; nothing if it can be looked at.
[[nodiscard]] std::optional<std::string> condition_rule(const TypeDescription& type,
                                                        const EventCondition& condition);

/// Whether all conditions hold in one message: those with [] in their field for the same element of the
/// sequence. `last` has the values of the fields that shall rise, by condition. False for bytes that are no
/// such message.
[[nodiscard]] bool all_hold(const std::vector<EventCondition>& conditions, const TypeDescription& type,
                            BytesView cdr, std::map<std::size_t, double>& last);

class EventWatch {
 public:
  explicit EventWatch(std::vector<Event> events) : events_(std::move(events)) {}

  /// Named by what is returned. `type` is null where nobody knows it: then only events without conditions
  /// count.
  std::size_t add_topic(const std::string& name, const TypeDescription* type);
  [[nodiscard]] bool is_watched(std::size_t topic) const { return !topics_[topic].watches.empty(); }
  /// The events that happen with the topic's next message.
  [[nodiscard]] std::vector<const Event*> look(std::size_t topic, BytesView cdr);

 private:
  /// What was seen of an event on one topic of one writer.
  struct Watch {
    const Event* event = nullptr;
    bool held = false;
    std::map<std::size_t, double> last;
  };
  struct Topic {
    const TypeDescription* type = nullptr;
    std::vector<Watch> watches;
  };
  const std::vector<Event> events_;
  std::vector<Topic> topics_;
};

}  // namespace bw::bag
