// Parameters as rcl_interfaces has them on the wire, and the questions that ROS 2's clients ask about them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <rcl_interfaces/msg/list_parameters_result.hpp>
#include <rcl_interfaces/msg/parameter.hpp>
#include <rcl_interfaces/msg/parameter_descriptor.hpp>

#include "runtime/parameters/parameter_descriptor.hpp"
#include "runtime/parameters/parameter_set.hpp"

namespace bw {

rcl_interfaces::msg::ParameterValue to_message(const ParameterValue& value);
/// Not set for a type that ROS 2 does not have.
ParameterValue from_message(const rcl_interfaces::msg::ParameterValue& message);

rcl_interfaces::msg::Parameter to_message(const NamedValue& parameter);
std::vector<NamedValue> from_messages(const std::vector<rcl_interfaces::msg::Parameter>& messages);

rcl_interfaces::msg::ParameterDescriptor to_message(const std::string& name,
                                                    const ParameterDescriptor& descriptor);

/// As rclcpp: a prefix stands for itself and for what lies below it, no prefix for everything; `depth` counts
/// the parts of a name below the prefix, 0 is without limit.
rcl_interfaces::msg::ListParametersResult list_names(std::span<const std::string> names,
                                                     std::span<const std::string> prefixes,
                                                     std::uint64_t depth);

}  // namespace bw
