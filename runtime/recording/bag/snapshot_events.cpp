#include "runtime/recording/bag/snapshot_events.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "runtime/event.hpp"
#include "runtime/parameters/nearest.hpp"
#include "runtime/recording/bag/event_watch.hpp"
#include "runtime/wire/type_registry.hpp"

namespace bw::bag {
namespace {

constexpr const char* kKey = "snapshot.on";
constexpr std::string_view kName = "{name}";

class Resolver {
 public:
  Resolver(const Graph& graph, const std::vector<ComponentDeclaration>& declarations) : graph_(graph) {
    // What every process publishes itself.
    types_ = {{"/diagnostics", "diagnostic_msgs/msg/DiagnosticArray"}, {"/rosout", "rcl_interfaces/msg/Log"}};
    for (const ComponentDeclaration& declaration : declarations) {
      const ComponentNode* node = graph.find(declaration.name);
      if (node == nullptr) continue;
      for (const OutputDeclaration& output : declaration.outputs)
        types_[node->topic_of(output.name)] = output.type;
    }
  }

  std::vector<Event> resolve(const SnapshotSettings& settings) {
    if (settings.on.empty()) {
      for (const DeclaredEvent& event : registered_events()) add_declared(event, settings.where);
    }
    for (const SnapshotEvent& event : settings.on) {
      event.own ? add_own(*event.own, event.where) : add_named(event);
    }
    if (violations_.empty() && events_.empty()) {
      violations_.push_back({settings.where, kKey, "",
                             "no component of this graph declares an event: name a topic, such as /bumper"});
    }
    throw_if_any(std::move(violations_));
    return std::move(events_);
  }

 private:
  void add_named(const SnapshotEvent& named) {
    const auto& known = registered_events();
    const auto event = std::ranges::find(known, named.name, &DeclaredEvent::name);
    if (event != known.end()) {
      const bool is_there = std::ranges::any_of(
          graph_.components, [&](const ComponentNode& node) { return node.type == event->component; });
      if (is_there) return add_declared(*event, named.where);
      violations_.push_back({named.where, kKey, named.name,
                             "tells of a component that this graph does not have: " + event->component});
      return;
    }
    std::vector<std::string_view> names;
    for (const DeclaredEvent& e : known) names.push_back(e.name);
    violations_.push_back({named.where, kKey, named.name,
                           unknown_rule("event", named.name, names) + "; a topic begins with /"});
  }

  /// Once for every component of its type.
  void add_declared(const DeclaredEvent& declared, const Location& where) {
    for (const ComponentNode& node : graph_.components) {
      if (node.type != declared.component || !node.enabled) continue;
      for (std::string& topic : topics_of(node, declared.topic)) {
        Event event{.name = declared.name, .topic = std::move(topic), .when = declared.when};
        for (EventCondition& condition : event.when) {
          if (condition.text == kName) condition.text = node.name;
        }
        add_own(event, where);
      }
    }
  }

  /// What is shared may tell each robot apart, below the robot's name.
  std::vector<std::string> topics_of(const ComponentNode& node, const std::string& declared) const {
    std::vector<std::string> topics;
    for (const std::string& robot : graph_.robots) {
      const std::string topic = node.topic_of(robot + "/" + declared);
      if (node.robot.empty() && types_.contains(topic)) topics.push_back(topic);
    }
    if (topics.empty()) topics.push_back(node.topic_of(declared));
    return topics;
  }

  void add_own(const Event& event, const Location& where) {
    const auto type = types_.find(event.topic);
    if (type == types_.end()) {
      std::vector<std::string_view> topics;
      for (const auto& [topic, name] : types_) topics.push_back(topic);
      const auto nearest = nearest_of(event.topic, topics);
      violations_.push_back({where, kKey, event.topic,
                             "nobody in this graph publishes it" +
                                 (nearest ? "; did you mean '" + std::string(*nearest) + "'?" : "")});
      return;
    }
    const TypeDescription* description = find_type(type->second);
    for (const EventCondition& condition : event.when) {
      const auto rule = description == nullptr
                            ? std::optional<std::string>("nobody knows the fields of its type")
                            : condition_rule(*description, condition);
      if (rule) violations_.push_back({where, kKey, event.topic + " " + condition.field, *rule});
    }
    events_.push_back(event);
  }

  const Graph& graph_;
  std::map<std::string, std::string> types_;  ///< by topic
  std::vector<Event> events_;
  std::vector<Violation> violations_;
};

}  // namespace

std::vector<Event> resolve_events(const SnapshotSettings& settings, const Graph& graph,
                                  const std::vector<ComponentDeclaration>& declarations) {
  return Resolver(graph, declarations).resolve(settings);
}

}  // namespace bw::bag
