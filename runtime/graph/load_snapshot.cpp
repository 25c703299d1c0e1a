#include <algorithm>
#include <utility>

#include "runtime/graph/graph_reading.hpp"
#include "runtime/graph/names.hpp"
#include "runtime/graph/snapshot_settings.hpp"
#include "runtime/parameters/read_parameters.hpp"
#include "runtime/parameters/scalar_text.hpp"

namespace bw {
namespace {

constexpr std::string_view kSection = "snapshot";

void read_memory(ParameterReader& reader, std::uint64_t& value) {
  const ConfigNode* node = reader.find("memory");
  if (node == nullptr) return;
  const std::optional<std::uint64_t> size = node->is_scalar() ? parse_size(node->scalar) : std::nullopt;
  if (size && *size >= SnapshotSettings::kLeastMemory) {
    value = *size;
  } else {
    reader.refuse(*node, "memory", "must be a size of at least 1MB, such as 256MB");
  }
}

/// A condition in a map beside `topic` and `field`: exactly one rule.
std::optional<EventCondition> read_condition(ParameterReader& reader, const ConfigNode& map,
                                             const std::string& field) {
  EventCondition condition{.field = field};
  int rules = 0;
  for (const EventRule rule : {EventRule::is, EventRule::is_not, EventRule::above, EventRule::below,
                               EventRule::begins_with, EventRule::rises}) {
    const ConfigNode* value = reader.find(to_text(rule));
    if (value == nullptr) continue;
    ++rules;
    condition.rule = rule;
    condition.text = value->scalar;
    condition.number = value->quoted ? std::nullopt : parse_number(value->scalar);
    const bool needs_number = rule == EventRule::above || rule == EventRule::below;
    if (!value->is_scalar() || (needs_number && !condition.number)) {
      reader.refuse(*value, to_text(rule), needs_number ? "must be a number" : "must be one value");
      return std::nullopt;
    }
  }
  if (rules == 1 && !field.empty()) return condition;
  reader.refuse(map, "field", "and one of is, is_not, above, below, begins_with, rises come together");
  return std::nullopt;
}

std::optional<SnapshotEvent> read_own(const ConfigNode& map, const std::string& key,
                                      std::vector<Violation>& violations) {
  const std::size_t before = violations.size();
  ParameterReader reader(map, key, violations);
  SnapshotEvent event{.where = map.where};
  Event own;
  reader("topic", own.topic);
  reader("name", event.name);
  std::string field;
  reader("field", field);
  const bool is_bare = map.map.size() == 1 || (map.map.size() == 2 && !event.name.empty());
  if (!is_bare) {
    if (auto condition = read_condition(reader, map, field)) own.when.push_back(*condition);
  }
  reader.refuse_unknown_keys();
  if (violations.size() > before) return std::nullopt;
  if (event.name.empty()) event.name = own.topic;
  const auto rule = topic_name_rule(own.topic);
  if (rule || !own.topic.starts_with('/')) {
    violations.push_back({map.where, joined(key, "topic"), own.topic, rule.value_or("must begin with /")});
    return std::nullopt;
  }
  own.name = event.name;
  event.own = std::move(own);
  return event;
}

void read_events(ParameterReader& reader, SnapshotSettings& settings, std::vector<Violation>& violations) {
  const ConfigNode* list = reader.find("on");
  if (list == nullptr) return;
  const std::string key = joined(kSection, "on");
  if (!is_list(*list, key, violations)) return;
  if (list->sequence.empty())
    reader.refuse(*list, "on", "must name an event; without `on` every declared one counts");
  for (const ConfigNode& node : list->sequence) {
    std::optional<SnapshotEvent> event;
    if (node.is_map()) {
      event = read_own(node, key, violations);
    } else if (node.is_scalar()) {
      event = snapshot_event(node.scalar, node.where, key, violations);
    } else {
      violations.push_back(
          {node.where, key, node.text(), "must be an event, a topic, or a map with a topic"});
    }
    if (event) settings.on.push_back(std::move(*event));
  }
}

}  // namespace

std::optional<SnapshotEvent> snapshot_event(const std::string& text, const Location& where,
                                            const std::string& key, std::vector<Violation>& violations) {
  if (!text.starts_with('/')) {
    if (!text.empty()) return SnapshotEvent{.name = text, .where = where};
    violations.push_back({where, key, text, "must be an event or a topic"});
    return std::nullopt;
  }
  if (const auto rule = topic_name_rule(text)) {
    violations.push_back({where, key, text, *rule});
    return std::nullopt;
  }
  return SnapshotEvent{.name = text, .own = Event{.name = text, .topic = text, .when = {}}, .where = where};
}

SnapshotSettings read_snapshot(const ConfigNode& section, std::vector<Violation>& violations) {
  SnapshotSettings settings{.where = section.where};
  if (!section.is_map()) {
    violations.push_back({section.where, std::string(kSection), section.text(),
                          "must be a map, such as {keep: 30s, on: [contact], to: snapshots}"});
    return settings;
  }
  ParameterReader reader(section, std::string(kSection), violations);
  settings.keep = read_span(reader, "keep", SnapshotSettings::kShortest, SnapshotSettings::kLongest, "30s")
                      .value_or(settings.keep);
  Duration after = settings.keep;
  after = read_span(reader, "after", Duration{}, SnapshotSettings::kLongest, "30s").value_or(after);
  settings.after = after;
  read_memory(reader, settings.memory);
  reader("most", settings.most, {.min = 1, .max = 10'000});
  std::string to;
  reader("to", to);
  if (to.empty()) {
    violations.push_back({section.where, joined(kSection, "to"), to, "must name a folder"});
  } else {
    settings.to = resolve_path(section.where, to);
  }
  read_events(reader, settings, violations);
  reader.refuse_unknown_keys();
  return settings;
}

}  // namespace bw
