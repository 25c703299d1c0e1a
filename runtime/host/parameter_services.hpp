// The six parameter services that every node of ROS 2 has, in front of what the node's component declared.
#pragma once

#include <functional>
#include <vector>

#include "runtime/component.hpp"
#include "runtime/live_parameters.hpp"

namespace bw {

/// Told after each change, for /parameter_events.
using OnParameterEvent = std::function<void(const Tick& tick, const std::vector<NamedValue>& changed)>;

/// Declares ~/get_parameters, ~/get_parameter_types, ~/describe_parameters, ~/list_parameters,
/// ~/set_parameters and ~/set_parameters_atomically. As rclcpp answers: a question that names an unknown
/// parameter gets an empty list.
/// A descriptor's additional constraints end with "default VALUE" where `rows` knows one. `parameters` and
/// `rows` must outlive the services.
void offer_parameter_services(Setup& setup, LiveParameters& parameters, const std::vector<ParameterRow>& rows,
                              OnParameterEvent on_event);

}  // namespace bw
