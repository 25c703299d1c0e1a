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

namespace detail {
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
                  std::int64_t lowest, std::int64_t highest, std::vector<Violation>& violations) {
  const std::optional<std::int64_t> parsed = is_plain(node) ? parse_integer(node.scalar) : std::nullopt;
  if (!parsed) {
    violations.push_back({node.where, key, node.text(), "must be a whole number"});
  } else if (!is_in_range(static_cast<double>(*parsed), field)) {
    violations.push_back({node.where, key, node.text(), range_rule(field)});
  } else if (*parsed < lowest || *parsed > highest) {
    violations.push_back({node.where, key, node.text(),
                          "must be between " + std::to_string(lowest) + " and " + std::to_string(highest)});
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

void read_string(const ConfigNode& node, const std::string& key, const Field& field, std::string& value,
                 std::vector<Violation>& violations) {
  if (!field.choices.empty()) {
    if (read_choice(node, key, field.choices, violations) != nullptr) value = node.scalar;
    return;
  }
  if (!node.is_scalar()) {
    violations.push_back({node.where, key, node.text(), "must be text"});
    return;
  }
  if (field.path && node.scalar.find('\0') != std::string::npos) {
    violations.push_back({node.where, key, node.text(), "must be a path"});
    return;
  }
  value = field.path && !node.scalar.empty() ? resolve_path(node.where, node.scalar).string() : node.scalar;
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

}  // namespace detail
}  // namespace bw
