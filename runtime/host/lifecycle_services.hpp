// What every managed node of ROS 2 offers (rclcpp_lifecycle): five services and the topic of its transitions.
#pragma once

#include <functional>

#include <lifecycle_msgs/msg/transition_event.hpp>

#include "runtime/component.hpp"
#include "runtime/host/actor.hpp"

namespace bw {

/// Declares ~/change_state, ~/get_state, ~/get_available_states, ~/get_available_transitions and
/// ~/get_transition_graph.
void offer_lifecycle_services(Setup& setup, Actor& actor);

/// Declares ~/transition_event; what it returns publishes a transition there.
std::function<void(const lifecycle::Transition& transition, Time now)> offer_transition_events(Setup& setup);

}  // namespace bw
