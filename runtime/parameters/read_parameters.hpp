// From a configuration to a parameter struct, by the struct's own field list. Keys that are missing keep
// their defaults. Everything else is refused: unknown key, wrong type, out of range, not finite, not among
// the choices, broken rule. All violations are reported.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/parameters/config_node.hpp"
#include "runtime/parameters/field_types.hpp"

namespace bw {

inline constexpr std::size_t kMaxListElements = 20'000;

/// Reads the keys of one map and remembers which ones it was asked for. It is the visitor of fields().
class ParameterReader final : public FieldVisitor {
 public:
  /// `map` may be null: a section without content has no keys. Both references must outlive the reader.
  ParameterReader(const ConfigNode& map, std::string path, std::vector<Violation>& violations);

  /// The value of a key, which is thereby known; nullptr if it is not given.
  const ConfigNode* find(std::string_view name);
  void refuse(const ConfigNode& node, std::string_view name, std::string rule);
  /// To be called after the last key was asked for.
  void refuse_unknown_keys();
  void retired(std::initializer_list<std::string_view> names, std::string_view instead) override;

 private:
  void visit(std::string_view name, FieldRef value, const Field& field) override;

  const ConfigNode& map_;
  std::string path_;
  std::vector<Violation>& violations_;
  std::vector<std::string> known_;
};

/// "must be between 0.1 and 100 Hz"
std::string range_rule(const Field&);
/// Whether the node can be one; else they add a violation.
bool is_section(const ConfigNode&, const std::string& key, std::vector<Violation>&);
bool is_list(const ConfigNode&, const std::string& key, std::vector<Violation>&);
/// Adds what it refuses to `violations`; `value` is then as it was, or partly read.
void read_value(const ConfigNode& node, const std::string& key, const Field& field, FieldRef value,
                std::vector<Violation>& violations);
template <class T>
requires(!std::same_as<T, FieldRef>) void read_value(const ConfigNode& node, const std::string& key,
                                                     const Field& field, T& value,
                                                     std::vector<Violation>& violations) {
  read_value(node, key, field, FieldRef::of(value), violations);
}

/// Adds what it refuses to `violations`; `value` is then partly read.
template <HasFields T>
void read_into(T& value, const ConfigNode& map, std::string_view path, std::vector<Violation>& violations) {
  read_value(map, std::string(path), Field{}, FieldRef::of(value), violations);
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
