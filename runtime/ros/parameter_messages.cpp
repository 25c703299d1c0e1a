#include "runtime/ros/parameter_messages.hpp"

#include <algorithm>
#include <type_traits>

namespace bw {
namespace {

/// Parts of a name that lie below its first.
std::uint64_t separators(std::string_view name) {
  return static_cast<std::uint64_t>(std::ranges::count(name, '.'));
}

bool is_listed(std::string_view name, std::span<const std::string> prefixes, std::uint64_t depth) {
  const auto is_near = [depth](std::string_view rest) { return depth == 0 || separators(rest) < depth; };
  if (prefixes.empty()) return is_near(name);
  return std::ranges::any_of(prefixes, [&](const std::string& prefix) {
    if (name == prefix) return true;
    const bool below = name.size() > prefix.size() && name.starts_with(prefix) && name[prefix.size()] == '.';
    return below && is_near(name.substr(prefix.size() + 1));
  });
}

}  // namespace

rcl_interfaces::msg::ParameterValue to_message(const ParameterValue& value) {
  rcl_interfaces::msg::ParameterValue message;
  message.type(static_cast<std::uint8_t>(type_of(value)));
  std::visit(
      [&message]<class T>(const T& held) {
        if constexpr (std::is_same_v<T, bool>) message.bool_value(held);
        if constexpr (std::is_same_v<T, std::int64_t>) message.integer_value(held);
        if constexpr (std::is_same_v<T, double>) message.double_value(held);
        if constexpr (std::is_same_v<T, std::string>) message.string_value(held);
        if constexpr (std::is_same_v<T, std::vector<std::uint8_t>>) message.byte_array_value(held);
        if constexpr (std::is_same_v<T, std::vector<bool>>) message.bool_array_value(held);
        if constexpr (std::is_same_v<T, std::vector<std::int64_t>>) message.integer_array_value(held);
        if constexpr (std::is_same_v<T, std::vector<double>>) message.double_array_value(held);
        if constexpr (std::is_same_v<T, std::vector<std::string>>) message.string_array_value(held);
      },
      value);
  return message;
}

ParameterValue from_message(const rcl_interfaces::msg::ParameterValue& message) {
  switch (static_cast<ParameterType>(message.type())) {
    case ParameterType::not_set:
      break;
    case ParameterType::boolean:
      return message.bool_value();
    case ParameterType::integer:
      return message.integer_value();
    case ParameterType::floating_point:
      return message.double_value();
    case ParameterType::string:
      return message.string_value();
    case ParameterType::byte_list:
      return message.byte_array_value();
    case ParameterType::bool_list:
      return message.bool_array_value();
    case ParameterType::integer_list:
      return message.integer_array_value();
    case ParameterType::double_list:
      return message.double_array_value();
    case ParameterType::string_list:
      return message.string_array_value();
  }
  return {};
}

rcl_interfaces::msg::Parameter to_message(const NamedValue& parameter) {
  rcl_interfaces::msg::Parameter message;
  message.name(parameter.name);
  message.value(to_message(parameter.value));
  return message;
}

std::vector<NamedValue> from_messages(const std::vector<rcl_interfaces::msg::Parameter>& messages) {
  std::vector<NamedValue> parameters;
  for (const auto& message : messages) parameters.push_back({message.name(), from_message(message.value())});
  return parameters;
}

rcl_interfaces::msg::ParameterDescriptor to_message(const std::string& name,
                                                    const ParameterDescriptor& descriptor) {
  rcl_interfaces::msg::ParameterDescriptor message;
  message.name(name);
  message.type(static_cast<std::uint8_t>(descriptor.type));
  message.description(descriptor.description);
  message.additional_constraints(descriptor.additional_constraints);
  message.read_only(descriptor.read_only);
  if (descriptor.double_range) {
    auto& range = message.floating_point_range().emplace_back();
    range.from_value(descriptor.double_range->from);
    range.to_value(descriptor.double_range->to);
  }
  if (descriptor.integer_range) {
    auto& range = message.integer_range().emplace_back();
    range.from_value(descriptor.integer_range->from);
    range.to_value(descriptor.integer_range->to);
  }
  return message;
}

rcl_interfaces::msg::ListParametersResult list_names(std::span<const std::string> names,
                                                     std::span<const std::string> prefixes,
                                                     std::uint64_t depth) {
  rcl_interfaces::msg::ListParametersResult result;
  for (const std::string& name : names) {
    if (!is_listed(name, prefixes, depth)) continue;
    result.names().push_back(name);
    const std::size_t dot = name.rfind('.');
    if (dot == std::string::npos) continue;
    std::string section = name.substr(0, dot);
    if (std::ranges::find(result.prefixes(), section) == result.prefixes().end())
      result.prefixes().push_back(std::move(section));
  }
  return result;
}

}  // namespace bw
