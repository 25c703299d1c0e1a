#include "runtime/parameters/parameter_set.hpp"

#include <algorithm>

#include "runtime/parameters/nearest.hpp"
#include "runtime/parameters/overrides.hpp"
#include "runtime/parameters/scalar_text.hpp"
#include "runtime/parameters/yaml_file.hpp"

namespace bw {
namespace {

constexpr std::size_t kLongestParameterName = 255;

bool is_empty_list(const ParameterValue& value) {
  return std::visit(
      []<class T>(const T& held) {
        if constexpr (detail::kIsVector<T>)
          return held.empty();
        else
          return false;
      },
      value);
}

bool is_list_type(ParameterType type) { return type >= ParameterType::byte_list; }

/// `value`, or an empty list of the type wanted in place of another empty list.
ParameterValue with_type(ParameterType wanted, const ParameterValue& value) {
  if (type_of(value) == wanted || !is_list_type(wanted) || !is_empty_list(value)) return value;
  if (wanted == ParameterType::byte_list) return std::vector<std::uint8_t>();
  if (wanted == ParameterType::bool_list) return std::vector<bool>();
  if (wanted == ParameterType::integer_list) return std::vector<std::int64_t>();
  if (wanted == ParameterType::double_list) return std::vector<double>();
  return std::vector<std::string>();
}

/// "rate expects a double, got an integer: write 1.0"
std::string type_rule(const std::string& name, ParameterType wanted, const ParameterValue& value) {
  std::string rule = name;
  rule.append(" expects ").append(name_of(wanted)).append(", got ").append(name_of(type_of(value)));
  if (const auto* whole = std::get_if<std::int64_t>(&value); whole && wanted == ParameterType::floating_point)
    rule.append(": write ").append(to_text(static_cast<double>(*whole)));
  if (std::holds_alternative<std::vector<std::int64_t>>(value) && wanted == ParameterType::double_list)
    rule.append(": write 1.0, not 1");
  if (type_of(value) == ParameterType::not_set) rule.append(": a parameter cannot be deleted");
  return rule;
}

/// Texts go into logs, YAML and JSON, and are kept.
bool is_text(const ParameterValue& value) {
  std::size_t bytes = 0;
  const auto fits = [&bytes](const std::string& text) {
    bytes += text.size();
    return bytes <= kMaxYamlBytes && is_config_text(text);
  };
  if (const auto* text = std::get_if<std::string>(&value)) return fits(*text);
  if (const auto* texts = std::get_if<std::vector<std::string>>(&value))
    return std::ranges::all_of(*texts, fits);
  return true;
}

std::string text_of(const std::vector<Violation>& violations) {
  std::string text;
  for (Violation violation : violations) {
    violation.where = {};
    // Without a place its text begins with ": ".
    text.append(text.empty() ? "" : "; ").append(violation.text().substr(2));
  }
  return text;
}

}  // namespace

ParameterSet::ParameterSet(std::vector<ParameterEntry> entries) {
  auto leaves = std::make_shared<Leaves>();
  for (ParameterEntry& entry : entries) {
    leaves->index_of.emplace(entry.name, values_.size());
    values_.push_back(entry.value);
  }
  leaves->entries = std::move(entries);
  leaves_ = std::move(leaves);
}

std::optional<std::size_t> ParameterSet::find(std::string_view name) const {
  const auto found = leaves_->index_of.find(name);
  return found == leaves_->index_of.end() ? std::nullopt : std::optional(found->second);
}

bool ParameterSet::has(std::string_view name) const {
  return held_ && find_dotted(held_->config(), name) != nullptr;
}

std::string ParameterSet::unknown(std::string_view name) const {
  if (name.size() > kLongestParameterName || !is_config_text(name))
    return "a parameter of this name does not exist";
  std::vector<std::string_view> names;
  for (const ParameterEntry& entry : leaves_->entries) names.push_back(entry.name);
  std::string rule = "unknown parameter '" + std::string(name) + "'";
  if (const auto nearest = nearest_of(name, names))
    rule.append("; did you mean '").append(*nearest).append("'?");
  return rule;
}

void ParameterSet::put(ConfigNode& section, std::size_t index, const ParameterValue& value,
                       const Holder& lists) const {
  const ParameterEntry& entry = leaves_->entries[index];
  // A list is read as a whole, so it is given as a whole.
  if (!entry.list.empty() && find_dotted(section, entry.list) == nullptr)
    apply_override(section, {parts_of(entry.list), *find_dotted(lists.config(), entry.list)});
  apply_override(section, {parts_of(entry.name), to_config_node(value)});
}

std::optional<std::string> ParameterSet::change(std::span<const NamedValue> changes) {
  ConfigNode section{.kind = ConfigNode::Kind::kMap, .where = {std::string(kOverrideFile), 0}};
  std::vector<std::pair<std::size_t, ParameterValue>> accepted;
  for (const NamedValue& wanted : changes) {
    const std::optional<std::size_t> index = find(wanted.name);
    if (!index) return unknown(wanted.name);
    const ParameterType type = type_of(values_[*index]);
    ParameterValue value = with_type(type, wanted.value);
    if (type_of(value) != type) return type_rule(wanted.name, type, value);
    if (!is_text(value))
      return wanted.name + " must be UTF-8 text without control characters, of at most 1 MiB";
    put(section, *index, value, *held_);
    accepted.emplace_back(*index, std::move(value));
  }
  if (accepted.empty()) return std::nullopt;
  std::vector<Violation> violations;
  std::shared_ptr<const Holder> next = held_->changed(section, violations);
  if (!violations.empty()) return text_of(violations);
  held_ = std::move(next);
  for (auto& [index, value] : accepted) {
    values_[index] = std::move(value);
    changed_.insert(index);
  }
  return std::nullopt;
}

void ParameterSet::write_changes(ConfigNode& section) const {
  for (const std::size_t index : changed_) put(section, index, values_[index], *held_);
}

}  // namespace bw
