#include "runtime/graph/fault_settings.hpp"

#include "runtime/graph/graph_reading.hpp"
#include "runtime/graph/names.hpp"
#include "runtime/parameters/read_parameters.hpp"

namespace bw {
namespace {

constexpr std::string_view kFaults = "faults";
constexpr Duration kLongestSpan = Duration::milliseconds(604'800'000);
constexpr Duration kShortestSpan = Duration::milliseconds(1);
constexpr std::string_view kSpan = "5s";  // for example

std::optional<FaultSettings> read_one(const ConfigEntry& entry, std::vector<Violation>& violations) {
  const std::string key = joined(kFaults, entry.key);
  if (const auto rule = node_name_rule(entry.key)) violations.push_back({entry.where, key, "", *rule});
  if (!entry.value.is_map() && !entry.value.is_null()) {
    violations.push_back({entry.where, key, entry.value.text(),
                          "must be a map, such as {kind: laser_silent, from: 5s, for: 3s}"});
    return std::nullopt;
  }
  FaultSettings fault{.name = entry.key, .kind = entry.key, .where = entry.where};
  ParameterReader reader(entry.value, key, violations);
  reader("kind", fault.kind);
  bool enabled = true;
  reader("enabled", enabled);
  fault.from = read_span(reader, "from", {}, kLongestSpan, kSpan).value_or(Duration{});
  fault.lasts = read_span(reader, "for", kShortestSpan, kLongestSpan, kSpan);
  fault.every = read_span(reader, "every", kShortestSpan, kLongestSpan, kSpan);
  if (const ConfigNode* every = entry.value.find("every");
      fault.every && (!fault.lasts || *fault.lasts >= *fault.every))
    reader.refuse(*every, "every", "needs a `for` that is shorter");
  read_name(reader, entry.value, "topic", fault.topic, topic_name_rule);
  read_name(reader, entry.value, "namespace", fault.node_namespace, namespace_rule);
  reader("of", fault.of);
  if (const ConfigNode* parameters = reader.find("parameters")) {
    if (is_section(*parameters, joined(key, "parameters"), violations)) fault.parameters = *parameters;
  }
  reader.refuse_unknown_keys();
  return enabled ? std::optional(std::move(fault)) : std::nullopt;
}

}  // namespace

std::optional<std::int64_t> FaultSettings::occurrence_at(Duration run) const {
  if (run < from) return std::nullopt;
  const std::int64_t occurrence = every ? (run - from).nanoseconds / every->nanoseconds : 0;
  if (lasts && run >= beginning_of(occurrence) + *lasts) return std::nullopt;
  return occurrence;
}

Duration FaultSettings::beginning_of(std::int64_t occurrence) const {
  return from + every.value_or(Duration{}) * occurrence;
}

std::vector<FaultSettings> read_faults(const ConfigNode& section, std::vector<Violation>& violations) {
  std::vector<FaultSettings> faults;
  if (section.is_null()) return faults;
  if (!section.is_map()) {
    violations.push_back({section.where, std::string(kFaults), section.text(), "must be a map of faults"});
    return faults;
  }
  for (const ConfigEntry& entry : section.map) {
    if (auto fault = read_one(entry, violations)) faults.push_back(std::move(*fault));
  }
  return faults;
}

}  // namespace bw
