#include "runtime/parameters/parameter_value.hpp"

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

#include "runtime/parameters/scalar_text.hpp"

namespace bw {
namespace {

const Location kRequest{std::string(kOverrideFile), 0};

template <class T>
inline constexpr bool kIsList = false;
template <class T>
inline constexpr bool kIsList<std::vector<T>> = true;

/// Bytes are written as integers.
template <class T>
auto scalar_of(const T& value) {
  if constexpr (std::is_same_v<T, std::uint8_t>)
    return static_cast<std::int64_t>(value);
  else
    return value;
}

template <class T>
ConfigNode scalar_node(const T& value) {
  ConfigNode node;
  node.kind = ConfigNode::Kind::kScalar;
  node.where = kRequest;
  if constexpr (std::is_same_v<T, std::string>) {
    node.scalar = value;
    node.quoted = true;
  } else {
    node.scalar = to_text(value);
  }
  return node;
}

/// A scalar as the narrowest type that it can be.
ParameterValue scalar_value(const ConfigNode& node) {
  if (node.quoted) return node.scalar;
  if (const auto value = parse_bool(node.scalar)) return *value;
  if (const auto value = parse_integer(node.scalar)) return *value;
  if (const auto value = parse_number(node.scalar)) return *value;
  return node.scalar;
}

template <class T>
ParameterValue list_of(const std::vector<ParameterValue>& values) {
  std::vector<T> list;
  for (const ParameterValue& value : values) list.push_back(std::get<T>(value));
  return list;
}

std::optional<ParameterValue> list_value(std::vector<ParameterValue> values) {
  const auto all_are = [&values](ParameterType type) {
    return std::ranges::all_of(values, [type](const ParameterValue& v) { return type_of(v) == type; });
  };
  // An empty list has no type; ROS 2's own tools send it as one of bools.
  if (all_are(ParameterType::boolean)) return list_of<bool>(values);
  if (all_are(ParameterType::integer)) return list_of<std::int64_t>(values);
  if (all_are(ParameterType::string)) return list_of<std::string>(values);
  for (ParameterValue& value : values) {
    if (const auto* whole = std::get_if<std::int64_t>(&value)) value = static_cast<double>(*whole);
  }
  if (all_are(ParameterType::floating_point)) return list_of<double>(values);
  return std::nullopt;
}

}  // namespace

std::string_view name_of(ParameterType type) {
  constexpr std::array<std::string_view, 10> kNames = {
      "nothing",         "a bool",          "an integer",         "a double",          "a string",
      "a list of bytes", "a list of bools", "a list of integers", "a list of doubles", "a list of strings"};
  return kNames.at(static_cast<std::size_t>(type));
}

std::string to_yaml_text(const ParameterValue& value) {
  return std::visit(
      []<class T>(const T& held) -> std::string {
        if constexpr (std::is_same_v<T, std::monostate>) {
          return "null";
        } else if constexpr (kIsList<T>) {
          std::string text;
          for (const auto& element : held)
            text.append(text.empty() ? "" : ", ").append(to_text(scalar_of(element)));
          return "[" + text + "]";
        } else {
          return to_text(held);
        }
      },
      value);
}

ConfigNode to_config_node(const ParameterValue& value) {
  return std::visit(
      []<class T>(const T& held) {
        ConfigNode node;
        node.where = kRequest;
        if constexpr (kIsList<T>) {
          node.kind = ConfigNode::Kind::kSequence;
          for (const auto& element : held) node.sequence.push_back(scalar_node(scalar_of(element)));
        } else if constexpr (!std::is_same_v<T, std::monostate>) {
          node = scalar_node(held);
        }
        return node;
      },
      value);
}

std::optional<ParameterValue> parameter_value_of(const ConfigNode& node) {
  if (node.is_scalar()) return scalar_value(node);
  if (!node.is_sequence()) return std::nullopt;
  std::vector<ParameterValue> values;
  for (const ConfigNode& element : node.sequence) {
    if (!element.is_scalar()) return std::nullopt;
    values.push_back(scalar_value(element));
  }
  return list_value(std::move(values));
}

}  // namespace bw
