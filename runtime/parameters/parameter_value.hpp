// A parameter's value as ROS 2 has it: one of ten types, told apart on the wire by a number. Without
// middleware; runtime/ros/parameter_messages.hpp has the message.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "runtime/parameters/config_node.hpp"

namespace bw {

/// The numbers of rcl_interfaces/msg/ParameterType, and the index in ParameterValue.
enum class ParameterType : std::uint8_t {
  not_set = 0,
  boolean = 1,
  integer = 2,
  floating_point = 3,
  string = 4,
  byte_list = 5,
  bool_list = 6,
  integer_list = 7,
  double_list = 8,
  string_list = 9,
};

using ParameterValue =
    std::variant<std::monostate, bool, std::int64_t, double, std::string, std::vector<std::uint8_t>,
                 std::vector<bool>, std::vector<std::int64_t>, std::vector<double>, std::vector<std::string>>;

inline ParameterType type_of(const ParameterValue& value) {
  return static_cast<ParameterType>(value.index());
}

/// "a double", "a list of strings"; "nothing" for not_set.
std::string_view name_of(ParameterType type);

/// As YAML on one line; reads back as the same value of the same type, but for bytes, which are integers in
/// YAML, and for an empty list, which has no type there.
std::string to_yaml_text(const ParameterValue& value);

/// As a configuration has it, located in kOverrideFile.
ConfigNode to_config_node(const ParameterValue& value);

/// The value that ROS 2's tools take a YAML text for: `1` is an integer, `1.0` a double, `true` a bool, `"1"`
/// a string; a list of one kind of these. Whole numbers among doubles are doubles. Nothing for a map, a null,
/// or a list of different kinds or of lists.
std::optional<ParameterValue> parameter_value_of(const ConfigNode& node);

}  // namespace bw
