#include "runtime/parameters/overrides.hpp"

#include <algorithm>
#include <utility>

#include "runtime/parameters/field_types.hpp"
#include "runtime/parameters/scalar_text.hpp"
#include "runtime/parameters/yaml_file.hpp"

namespace bw {
namespace {

const Location kCommandLine{std::string(kOverrideFile), 0};

[[noreturn]] void refuse(const std::string& key, const std::string& value, std::string rule) {
  throw ConfigError(Violation{kCommandLine, key, value, std::move(rule)});
}

/// The element of a list, appended if it is the next one.
ConfigNode& element_of(ConfigNode& list, const std::string& part, const Override& change) {
  const std::optional<std::int64_t> index = parse_integer(part);
  const std::size_t size = list.sequence.size();
  if (!index || *index < 0 || std::cmp_greater(*index, size)) {
    refuse(change.key(), change.value.text(),
           "'" + part + "' must be a list index between 0 and " + std::to_string(size));
  }
  if (std::cmp_equal(*index, size)) list.sequence.emplace_back().where = kCommandLine;
  return list.sequence[static_cast<std::size_t>(*index)];
}

}  // namespace

std::string Override::key() const {
  std::string out;
  for (const std::string& part : path) out = joined(out, part);
  return out;
}

std::vector<std::string> parts_of(std::string_view dotted) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t dot = dotted.find('.');
    parts.emplace_back(dotted.substr(0, dot));
    if (dot == std::string_view::npos) return parts;
    dotted.remove_prefix(dot + 1);
  }
}

Override parse_override(std::string_view text) {
  const std::size_t equals = text.find('=');
  const std::string name(text.substr(0, equals));
  if (equals == std::string_view::npos) refuse(name, "", "must have the form component.param=value");
  Override change;
  change.path = parts_of(name);
  if (std::ranges::find(change.path, "") != change.path.end())
    refuse(name, "", "must have the form component.param=value");
  if (change.path.size() > kMaxYamlDepth) refuse(name, "", "nested too deeply");
  try {
    change.value = parse_yaml(text.substr(equals + 1), std::string(kOverrideFile));
  } catch (const ConfigError& error) {
    refuse(name, std::string(text.substr(equals + 1)),
           "must be a YAML value; " + error.violations().front().rule);
  }
  return change;
}

void apply_override(ConfigNode& root, const Override& change, std::size_t first) {
  ConfigNode* node = &root;
  for (std::size_t i = first; i < change.path.size(); ++i) {
    const std::string& part = change.path[i];
    if (node->is_sequence()) {
      node = &element_of(*node, part, change);
      continue;
    }
    if (node->is_scalar()) {
      refuse(change.key(), change.value.text(),
             "'" + change.path[i - 1] + "' has no parts, it is " + node->text());
    }
    if (parse_integer(part)) {
      refuse(change.key(), change.value.text(),
             "no list to index is given here; set the whole list, as name=[...]");
    }
    node->kind = ConfigNode::Kind::kMap;
    ConfigNode* child = node->find(part);
    if (child == nullptr) {
      node->map.push_back({part, kCommandLine, {}});
      child = &node->map.back().value;
      child->where = kCommandLine;
    }
    node = child;
  }
  *node = change.value;
}

void put_over(ConfigNode& base, const ConfigNode& own) {
  if (!base.is_map() || !own.is_map()) {
    base = own;
    return;
  }
  for (const ConfigEntry& entry : own.map) {
    if (ConfigNode* value = base.find(entry.key)) {
      put_over(*value, entry.value);
    } else {
      base.map.push_back(entry);
    }
  }
}

}  // namespace bw
