// One request and one response of each service type that ROS 2's tools call most, as messages of this
// project. Their bytes, worked out by hand, are in service_golden.hpp.
#pragma once

#include <string>
#include <vector>

#include <lifecycle_msgs/srv/change_state.hpp>
#include <lifecycle_msgs/srv/get_available_states.hpp>
#include <lifecycle_msgs/srv/get_available_transitions.hpp>
#include <lifecycle_msgs/srv/get_state.hpp>
#include <rcl_interfaces/srv/describe_parameters.hpp>
#include <rcl_interfaces/srv/get_parameter_types.hpp>
#include <rcl_interfaces/srv/get_parameters.hpp>
#include <rcl_interfaces/srv/list_parameters.hpp>
#include <rcl_interfaces/srv/set_parameters.hpp>
#include <rcl_interfaces/srv/set_parameters_atomically.hpp>
#include <std_srvs/srv/empty.hpp>
#include <std_srvs/srv/set_bool.hpp>
#include <std_srvs/srv/trigger.hpp>

namespace bw::test {

template <class S>
struct Example {
  std::string service;  ///< its last part
  typename S::Request request = {};
  typename S::Response response = {};
};

inline rcl_interfaces::msg::ParameterValue of_type(std::uint8_t type, double number = 0.0) {
  rcl_interfaces::msg::ParameterValue value;
  value.type(type);
  value.double_value(number);
  return value;
}

template <class M>
M labelled(std::uint8_t id, const std::string& label) {
  M message;
  message.id(id);
  message.label(label);
  return message;
}

inline constexpr std::uint8_t kBool = 1, kDouble = 3;

/// Calls `see(example)` with every example.
template <class See>
void for_each_example(See see) {
  using lifecycle_msgs::msg::State;
  using lifecycle_msgs::msg::Transition;
  {
    Example<std_srvs::srv::Trigger> e{"trigger"};
    e.response.success(true);
    e.response.message("asked");
    see(e);
  }
  see(Example<std_srvs::srv::Empty>{"empty"});
  {
    Example<std_srvs::srv::SetBool> e{"set_bool"};
    e.request.data(true);
    e.response.message("no");
    see(e);
  }
  {
    Example<rcl_interfaces::srv::ListParameters> e{"list_parameters"};
    e.request.prefixes({"limits"});
    e.request.depth(1);
    e.response.result().names({"limits.v_max"});
    e.response.result().prefixes({"limits"});
    see(e);
  }
  {
    Example<rcl_interfaces::srv::GetParameters> e{"get_parameters"};
    e.request.names({"limits.v_max", "use_sim_time"});
    e.response.values({of_type(kDouble, 0.75), of_type(kBool)});
    see(e);
  }
  {
    Example<rcl_interfaces::srv::GetParameterTypes> e{"get_parameter_types"};
    e.request.names({"limits.v_max", "use_sim_time"});
    e.response.types({kDouble, kBool});
    see(e);
  }
  rcl_interfaces::msg::Parameter half;
  half.name("limits.v_max");
  half.value(of_type(kDouble, 0.5));
  {
    Example<rcl_interfaces::srv::SetParameters> e{"set_parameters"};
    e.request.parameters({half});
    rcl_interfaces::msg::SetParametersResult refused;
    refused.reason("must be at most 2");
    e.response.results({refused});
    see(e);
  }
  {
    Example<rcl_interfaces::srv::SetParametersAtomically> e{"set_parameters_atomically"};
    e.request.parameters({half});
    e.response.result().successful(true);
    see(e);
  }
  {
    Example<rcl_interfaces::srv::DescribeParameters> e{"describe_parameters"};
    e.request.names({"limits.v_max"});
    rcl_interfaces::msg::FloatingPointRange range;
    range.to_value(2.0);
    rcl_interfaces::msg::ParameterDescriptor descriptor;
    descriptor.name("limits.v_max");
    descriptor.type(kDouble);
    descriptor.description("top speed");
    descriptor.additional_constraints("default 0.75");
    descriptor.floating_point_range({range});
    e.response.descriptors({descriptor});
    see(e);
  }
  {
    Example<lifecycle_msgs::srv::GetState> e{"get_state"};
    e.response.current_state(labelled<State>(3, "active"));
    see(e);
  }
  {
    Example<lifecycle_msgs::srv::ChangeState> e{"change_state"};
    e.request.transition(labelled<Transition>(3, "activate"));
    e.response.success(true);
    see(e);
  }
  {
    Example<lifecycle_msgs::srv::GetAvailableStates> e{"get_available_states"};
    e.response.available_states({labelled<State>(1, "unconfigured"), labelled<State>(3, "active")});
    see(e);
  }
  {
    Example<lifecycle_msgs::srv::GetAvailableTransitions> e{"get_available_transitions"};
    lifecycle_msgs::msg::TransitionDescription configure;
    configure.transition(labelled<Transition>(1, "configure"));
    configure.start_state(labelled<State>(1, "unconfigured"));
    configure.goal_state(labelled<State>(2, "inactive"));
    e.response.available_transitions({configure});
    see(e);
  }
}

}  // namespace bw::test
