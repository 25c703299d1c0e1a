// Events worth a snapshot of the last seconds, declared where the component lives that tells of them:
//
//   BW_EVENT(contact, "world", "sim/ground_truth", "the robot touches something",
//            {{.field = "contacts", .rule = bw::EventRule::rises}})
//
// A graph names it in `snapshot: {on: [contact]}`.
#pragma once

#include <string>
#include <vector>

#include "runtime/graph/event.hpp"

namespace bw {

struct DeclaredEvent {
  std::string name;
  std::string component;  ///< type of the component that tells of it
  std::string topic;      ///< as the component declares its output, or absolute
  std::string doc;
  /// A text `{name}` stands for the name of the component in the graph.
  std::vector<EventCondition> when;
};

/// Makes an event known by name. Throws std::logic_error when the name is taken.
bool register_event(DeclaredEvent event);

/// Sorted by name.
[[nodiscard]] const std::vector<DeclaredEvent>& registered_events();

}  // namespace bw

/// Once per event, in a source file of its component.
#define BW_EVENT(name, component, topic, doc, ...)                       \
  namespace {                                                            \
  [[maybe_unused]] const bool event_##name =                             \
      ::bw::register_event({#name, component, topic, doc, __VA_ARGS__}); \
  }
