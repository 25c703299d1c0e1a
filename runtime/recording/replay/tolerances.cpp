#include "runtime/recording/replay/tolerances.hpp"

#include <algorithm>
#include <string_view>

#include "runtime/parameters/nearest.hpp"
#include "runtime/parameters/scalar_text.hpp"
#include "runtime/wire/type_registry.hpp"

namespace bw::replay {
namespace {

constexpr std::string_view kLeftOut = "left_out";

/// `field` is `name` or stands below it.
bool is_of(std::string_view field, std::string_view name) {
  return field.starts_with(name) && (field.size() == name.size() || field[name.size()] == '.');
}

/// Why `name` is no field of the type; nothing if it is one.
std::optional<std::string> field_rule(const TypeDescription& type, std::string_view name) {
  const TypeDescription* inside = &type;
  while (true) {
    const std::string_view part = name.substr(0, name.find('.'));
    if (inside == nullptr) return "'" + std::string(part) + "' stands below a field that has no parts";
    const auto field = std::ranges::find(inside->fields, part, &FieldDescription::name);
    if (field == inside->fields.end()) {
      std::vector<std::string_view> known;
      for (const FieldDescription& f : inside->fields) known.push_back(f.name);
      return unknown_rule("field of " + std::string(inside->ros_name), part, known);
    }
    if (part.size() == name.size()) return std::nullopt;
    name.remove_prefix(part.size() + 1);
    inside = field->message;
  }
}

}  // namespace

bool TopicTolerances::leaves_out(const std::string& field) const {
  return std::ranges::any_of(left_out, [&](const std::string& name) { return is_of(field, name); });
}

double TopicTolerances::allowed(const std::string& field) const {
  std::size_t longest = 0;
  double tolerance = 0.0;
  for (const auto& [name, value] : absolute) {
    if (!is_of(field, name) || name.size() < longest) continue;
    longest = name.size();
    tolerance = value;
  }
  return tolerance;
}

Tolerances read_tolerances(const ConfigNode& section, const std::vector<bag::BagTopic>& topics) {
  Tolerances tolerances;
  std::vector<Violation> violations;
  for (const ConfigEntry& topic : section.map) {
    const std::string key = "tolerances." + topic.key;
    if (!topic.value.is_map()) {
      violations.push_back(
          {topic.where, key, topic.value.text(), "must be a map of fields to a number or left_out"});
      continue;
    }
    const auto recorded = std::ranges::find(topics, topic.key, &bag::BagTopic::name);
    const TypeDescription* type = recorded == topics.end() ? nullptr : find_type(recorded->type);
    TopicTolerances& fields = tolerances[topic.key];
    for (const ConfigEntry& field : topic.value.map) {
      const std::string field_key = key + "." + field.key;
      if (const auto rule = type == nullptr ? std::nullopt : field_rule(*type, field.key)) {
        violations.push_back({field.where, field_key, "", *rule});
      }
      const auto number = field.value.is_scalar() ? parse_number(field.value.scalar) : std::nullopt;
      if (field.value.is_scalar() && field.value.scalar == kLeftOut) {
        fields.left_out.push_back(field.key);
      } else if (number && *number >= 0.0) {
        fields.absolute[field.key] = *number;
      } else {
        violations.push_back({field.value.where, field_key, field.value.text(),
                              "must be a number of at least 0, or left_out"});
      }
    }
  }
  throw_if_any(std::move(violations));
  return tolerances;
}

}  // namespace bw::replay
