// From a configuration to a parameter struct, by the struct's own field list. Keys that are missing keep
// their defaults. Everything else is refused: unknown key, wrong type, out of range, not finite, not among
// the choices, broken rule. All violations are reported.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/parameters/config_node.hpp"
#include "runtime/parameters/field_types.hpp"

namespace bw {

inline constexpr std::size_t kMaxListElements = 20'000;

/// Reads the keys of one map and remembers which ones it was asked for. It is the visitor of fields().
class ParameterReader {
 public:
  /// `map` may be null: a section without content has no keys. Both references must outlive the reader.
  ParameterReader(const ConfigNode& map, std::string path, std::vector<Violation>& violations);

  template <class T>
  void operator()(std::string_view name, T& value, const Field& field = {});

  /// The value of a key, which is thereby known; nullptr if it is not given.
  const ConfigNode* find(std::string_view name);
  void refuse(const ConfigNode& node, std::string_view name, std::string rule);
  /// To be called after the last key was asked for.
  void refuse_unknown_keys();

 private:
  const ConfigNode& map_;
  std::string path_;
  std::vector<Violation>& violations_;
  std::vector<std::string> known_;
};

namespace detail {

/// "must be between 0.1 and 100 Hz"
std::string range_rule(const Field&);
void read_bool(const ConfigNode&, const std::string& key, bool&, std::vector<Violation>&);
bool read_integer(const ConfigNode&, const std::string& key, const Field&, std::int64_t& value,
                  std::int64_t lowest, std::int64_t highest, std::vector<Violation>&);
void read_double(const ConfigNode&, const std::string& key, const Field&, double&, std::vector<Violation>&);
void read_string(const ConfigNode&, const std::string& key, const Field&, std::string&,
                 std::vector<Violation>&);
/// The scalar, if it is one of `choices`.
const std::string* read_choice(const ConfigNode&, const std::string& key,
                               const std::vector<std::string_view>& choices, std::vector<Violation>&);
bool is_list(const ConfigNode&, const std::string& key, std::vector<Violation>&);
bool is_section(const ConfigNode&, const std::string& key, std::vector<Violation>&);

template <class T>
void read_value(const ConfigNode& node, const std::string& key, const Field& field, T& value,
                std::vector<Violation>& violations) {
  if constexpr (std::same_as<T, bool>) {
    read_bool(node, key, value, violations);
  } else if constexpr (IntegerField<T>) {
    constexpr auto kInt64 = std::numeric_limits<std::int64_t>::max();
    constexpr auto kLowest = static_cast<std::int64_t>(std::numeric_limits<T>::min());
    constexpr auto kHighest = std::cmp_less(kInt64, std::numeric_limits<T>::max())
                                  ? kInt64
                                  : static_cast<std::int64_t>(std::numeric_limits<T>::max());
    std::int64_t integer = 0;
    if (read_integer(node, key, field, integer, kLowest, kHighest, violations))
      value = static_cast<T>(integer);
  } else if constexpr (std::same_as<T, double>) {
    read_double(node, key, field, value, violations);
  } else if constexpr (std::same_as<T, std::string>) {
    read_string(node, key, field, value, violations);
  } else if constexpr (ChoiceField<T>) {
    if (const std::string* text = read_choice(node, key, choice_texts<T>(), violations))
      value = *choice_of<T>(*text);
  } else if constexpr (ListField<T>) {
    if (!is_list(node, key, violations)) return;
    T list;
    list.reserve(node.sequence.size());
    for (const ConfigNode& element : node.sequence) {
      typename T::value_type item{};
      read_value(element, joined(key, std::to_string(list.size())), field, item, violations);
      list.push_back(std::move(item));
    }
    value = std::move(list);
  } else {
    static_assert(
        HasFields<T>,
        "a field is a bool, integer, double, string, enum with choice_table(), struct with fields(), "
        "or a vector of these");
    if (!is_section(node, key, violations)) return;
    const std::size_t before = violations.size();
    ParameterReader reader(node, key, violations);
    value.fields(reader);
    if constexpr (!requires { T::leaves_other_keys; }) reader.refuse_unknown_keys();
    // A rule over fields says nothing once one of them is refused.
    if constexpr (HasRule<T>) {
      if (violations.size() > before) return;
      if (std::optional<std::string> rule = value.violated_rule())
        violations.push_back({node.where, key, "", *rule});
    }
  }
}

}  // namespace detail

template <class T>
void ParameterReader::operator()(std::string_view name, T& value, const Field& field) {
  if (const ConfigNode* node = find(name))
    detail::read_value(*node, joined(path_, name), field, value, violations_);
}

/// Adds what it refuses to `violations`; `value` is then partly read.
template <HasFields T>
void read_into(T& value, const ConfigNode& map, std::string_view path, std::vector<Violation>& violations) {
  detail::read_value(map, std::string(path), Field{}, value, violations);
}

/// Throws ConfigError with all violations; `value` is then unchanged. `path` stands before every key in
/// messages.
template <HasFields T>
void read_into(T& value, const ConfigNode& map, std::string_view path) {
  T copy = value;
  std::vector<Violation> violations;
  read_into(copy, map, path, violations);
  throw_if_any(std::move(violations));
  value = std::move(copy);
}

template <HasFields T>
T read_parameters(const ConfigNode& map, std::string_view path) {
  T value{};
  read_into(value, map, path);
  return value;
}

}  // namespace bw
