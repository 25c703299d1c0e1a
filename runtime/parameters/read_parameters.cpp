#include "runtime/parameters/read_parameters.hpp"

#include <algorithm>
#include <cmath>

#include "runtime/parameters/nearest.hpp"
#include "runtime/parameters/scalar_text.hpp"

namespace bw {

ParameterReader::ParameterReader(const ConfigNode& map, std::string path, std::vector<Violation>& violations)
    : map_(map), path_(std::move(path)), violations_(violations) {}

const ConfigNode* ParameterReader::find(std::string_view name) {
  known_.emplace_back(name);
  return map_.find(name);
}

void ParameterReader::refuse(const ConfigNode& node, std::string_view name, std::string rule) {
  violations_.push_back({node.where, joined(path_, name), node.text(), std::move(rule)});
}

void ParameterReader::refuse_unknown_keys() {
  const std::vector<std::string_view> known(known_.begin(), known_.end());
  for (const ConfigEntry& entry : map_.map) {
    if (std::find(known.begin(), known.end(), entry.key) != known.end()) continue;
    violations_.push_back({entry.where, joined(path_, entry.key), "", unknown_rule("key", entry.key, known)});
  }
}

void ParameterReader::retired(std::initializer_list<std::string_view> names, std::string_view instead) {
  for (const std::string_view name : names) {
    if (const ConfigNode* node = find(name))
      refuse(*node, name, "is no parameter any more: " + std::string(instead));
  }
}

namespace {

bool is_in_range(double value, const Field& field) { return value >= field.min && value <= field.max; }

std::string number_rule(const Field& field) {
  return field.unit.empty() ? "must be a number" : "must be a number of " + std::string(field.unit);
}

bool is_plain(const ConfigNode& node) { return node.is_scalar() && !node.quoted; }

}  // namespace

std::string range_rule(const Field& field) {
  const bool below = std::isfinite(field.min), above = std::isfinite(field.max);
  std::string rule = "must be ";
  if (below && above) {
    rule.append("between ").append(short_text(field.min)).append(" and ").append(short_text(field.max));
  } else if (below) {
    rule.append("at least ").append(short_text(field.min));
  } else {
    rule.append("at most ").append(short_text(field.max));
  }
  return field.unit.empty() ? rule : rule.append(" ").append(field.unit);
}

bool is_list(const ConfigNode& node, const std::string& key, std::vector<Violation>& violations) {
  if (!node.is_sequence()) {
    violations.push_back({node.where, key, node.text(), "must be a list"});
  } else if (node.sequence.size() > kMaxListElements) {
    violations.push_back({node.where, key, std::to_string(node.sequence.size()) + " elements",
                          "must have at most " + std::to_string(kMaxListElements) + " elements"});
  } else {
    return true;
  }
  return false;
}

bool is_section(const ConfigNode& node, const std::string& key, std::vector<Violation>& violations) {
  if (node.is_map() || node.is_null()) return true;
  violations.push_back({node.where, key, node.text(), "must be a map of parameters"});
  return false;
}

namespace {

void read_bool(const ConfigNode& node, const std::string& key, bool& value,
               std::vector<Violation>& violations) {
  const std::optional<bool> parsed = is_plain(node) ? parse_bool(node.scalar) : std::nullopt;
  if (parsed) {
    value = *parsed;
  } else {
    violations.push_back({node.where, key, node.text(), "must be true or false"});
  }
}

bool read_integer(const ConfigNode& node, const std::string& key, const Field& field, std::int64_t& value,
                  const FieldType& type, std::vector<Violation>& violations) {
  const std::optional<std::int64_t> parsed = is_plain(node) ? parse_integer(node.scalar) : std::nullopt;
  if (!parsed) {
    violations.push_back({node.where, key, node.text(), "must be a whole number"});
  } else if (!is_in_range(static_cast<double>(*parsed), field)) {
    violations.push_back({node.where, key, node.text(), range_rule(field)});
  } else if (*parsed < type.lowest || *parsed > type.highest) {
    violations.push_back(
        {node.where, key, node.text(),
         "must be between " + std::to_string(type.lowest) + " and " + std::to_string(type.highest)});
  } else {
    value = *parsed;
    return true;
  }
  return false;
}

void read_double(const ConfigNode& node, const std::string& key, const Field& field, double& value,
                 std::vector<Violation>& violations) {
  const std::optional<double> parsed = is_plain(node) ? parse_number(node.scalar) : std::nullopt;
  if (!parsed) {
    violations.push_back({node.where, key, node.text(), number_rule(field)});
  } else if (std::isnan(*parsed) || (std::isinf(*parsed) && !field.infinity)) {
    violations.push_back({node.where, key, node.text(), "must be a finite number"});
  } else if (!is_in_range(*parsed, field)) {
    violations.push_back({node.where, key, node.text(), range_rule(field)});
  } else {
    value = *parsed;
  }
}

const std::string* read_choice(const ConfigNode& node, const std::string& key,
                               const std::vector<std::string_view>& choices,
                               std::vector<Violation>& violations) {
  if (!node.is_scalar()) {
    violations.push_back({node.where, key, node.text(), "must be text"});
    return nullptr;
  }
  if (std::find(choices.begin(), choices.end(), node.scalar) != choices.end()) return &node.scalar;
  std::string rule = "must be one of " + comma_separated(choices);
  if (const auto nearest = nearest_of(node.scalar, choices))
    rule.append("; did you mean '").append(*nearest).append("'?");
  violations.push_back({node.where, key, node.text(), std::move(rule)});
  return nullptr;
}

/// "[[0.2, 0.1], ...]"
std::string text_of_list(const ConfigNode& node) {
  if (!node.is_sequence()) return node.text();
  std::string text = "[";
  for (const ConfigNode& element : node.sequence)
    text.append(text.size() > 1 ? ", " : "").append(text_of_list(element));
  return text + "]";
}

void read_string(const ConfigNode& node, const std::string& key, const Field& field, std::string& value,
                 std::vector<Violation>& violations) {
  const bool is_file_beside =
      !field.choices.empty() && field.path && node.is_scalar() && node.scalar.find('/') != std::string::npos;
  if (!field.choices.empty() && !is_file_beside) {
    if (read_choice(node, key, field.choices.all(), violations) != nullptr) value = node.scalar;
    return;
  }
  const bool is_list = field.list_as_text && node.is_sequence();
  if (!node.is_scalar() && !is_list) {
    violations.push_back({node.where, key, node.text(), "must be text"});
    return;
  }
  if (field.path && node.scalar.find('\0') != std::string::npos) {
    violations.push_back({node.where, key, node.text(), "must be a path"});
    return;
  }
  value = is_list                              ? text_of_list(node)
          : field.path && !node.scalar.empty() ? resolve_path(node.where, node.scalar).string()
                                               : node.scalar;
  if (is_file_beside) value = std::filesystem::absolute(value).string();  // none of the choices looks like it
  if (field.rule == nullptr) return;
  if (std::string why = field.rule(value); !why.empty())
    violations.push_back({node.where, key, node.text(), std::move(why)});
}

void read_list(const ConfigNode& node, const std::string& key, const Field& field, FieldRef value,
               std::vector<Violation>& violations) {
  if (!is_list(node, key, violations)) return;
  auto element = node.sequence.begin();
  value.replace(node.sequence.size(), [&](FieldRef item) {
    const auto index = element - node.sequence.begin();
    read_value(*element++, joined(key, std::to_string(index)), field, item, violations);
  });
}

void read_section(const ConfigNode& node, const std::string& key, FieldRef value,
                  std::vector<Violation>& violations) {
  if (!is_section(node, key, violations)) return;
  const std::size_t before = violations.size();
  ParameterReader reader(node, key, violations);
  value.accept(reader);
  if (!value.type().leaves_other_keys) reader.refuse_unknown_keys();
  // A rule over fields says nothing once one of them is refused.
  if (violations.size() > before) return;
  if (std::optional<std::string> rule = value.violated_rule())
    violations.push_back({node.where, key, "", std::move(*rule)});
}

}  // namespace

void read_value(const ConfigNode& node, const std::string& key, const Field& field, FieldRef value,
                std::vector<Violation>& violations) {
  switch (value.kind()) {
    case FieldKind::boolean:
      return read_bool(node, key, value.boolean(), violations);
    case FieldKind::integer:
      if (std::int64_t read = 0; read_integer(node, key, field, read, value.type(), violations))
        value.set_integer(read);
      return;
    case FieldKind::number:
      return read_double(node, key, field, value.number(), violations);
    case FieldKind::text:
      return read_string(node, key, field, value.text(), violations);
    case FieldKind::choice:
      if (const std::string* text = read_choice(node, key, value.type().texts(), violations))
        value.set_choice(*text);
      return;
    case FieldKind::list:
      return read_list(node, key, field, value, violations);
    case FieldKind::section:
      return read_section(node, key, value, violations);
  }
}

void ParameterReader::visit(std::string_view name, FieldRef value, const Field& field) {
  if (const ConfigNode* node = find(name)) read_value(*node, joined(path_, name), field, value, violations_);
}

}  // namespace bw
