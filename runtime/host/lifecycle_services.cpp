#include "runtime/host/lifecycle_services.hpp"

#include <string>

#include <lifecycle_msgs/srv/change_state.hpp>
#include <lifecycle_msgs/srv/get_available_states.hpp>
#include <lifecycle_msgs/srv/get_available_transitions.hpp>
#include <lifecycle_msgs/srv/get_state.hpp>

#include "runtime/host/nested_lifecycle.hpp"

namespace bw {
namespace {

using lifecycle_msgs::srv::ChangeState;
using lifecycle_msgs::srv::GetAvailableStates;
using lifecycle_msgs::srv::GetAvailableTransitions;
using lifecycle_msgs::srv::GetState;

lifecycle_msgs::msg::State to_message(lifecycle::State state) {
  lifecycle_msgs::msg::State message;
  message.id(static_cast<std::uint8_t>(state));
  message.label(std::string(lifecycle::label(state)));
  return message;
}

lifecycle_msgs::msg::Transition to_message(const lifecycle::Transition& transition) {
  lifecycle_msgs::msg::Transition message;
  message.id(transition.id);
  message.label(std::string(transition.label));
  return message;
}

template <class Transitions>
GetAvailableTransitions::Response to_response(const Transitions& transitions) {
  GetAvailableTransitions::Response response;
  for (const lifecycle::Transition& transition : transitions) {
    lifecycle_msgs::msg::TransitionDescription& description = response.available_transitions().emplace_back();
    description.transition(to_message(transition));
    description.start_state(to_message(transition.start));
    description.goal_state(to_message(transition.goal));
  }
  return response;
}

void change_state(Actor& actor, const ChangeState::Request& request, const Reply<ChangeState>& reply,
                  const Tick& tick, const Logger& log) {
  const auto& asked = request.transition();
  const auto answer = [reply](bool success) {
    ChangeState::Response response;
    response.success(success);
    reply(response);
  };
  const lifecycle::Transition* transition =
      lifecycle::requested_transition(actor.state, asked.id(), asked.label());
  if (transition == nullptr) {
    log.warn("no transition {} from {}", asked.label().empty() ? std::to_string(asked.id()) : asked.label(),
             lifecycle::label(actor.state));
    answer(false);
  } else if (actor.led) {
    actor.led->change(*transition, tick.now, answer);
  } else {
    answer(actor.lifecycle->change(*transition, tick.now).empty());
  }
}

}  // namespace

void offer_lifecycle_services(Setup& setup, Actor& actor) {
  setup.service<ChangeState>(
      "~/change_state",
      [&actor, log = setup.log()](const ChangeState::Request& request, const Reply<ChangeState>& reply,
                                  const Tick& tick) { change_state(actor, request, reply, tick, log); },
      [log = setup.log()](const std::string& reason) {
        log.warn("change_state refused: {}", reason);
        ChangeState::Response response;
        response.success(false);
        return response;
      },
      ServiceScope::node);
  setup.service<GetState>(
      "~/get_state",
      [&actor](const GetState::Request&, const Tick&) {
        GetState::Response response;
        response.current_state(to_message(actor.state));
        return response;
      },
      nullptr, ServiceScope::node);
  setup.service<GetAvailableStates>(
      "~/get_available_states",
      [](const GetAvailableStates::Request&, const Tick&) {
        GetAvailableStates::Response response;
        for (const lifecycle::State state : lifecycle::states())
          response.available_states().push_back(to_message(state));
        return response;
      },
      nullptr, ServiceScope::node);
  setup.service<GetAvailableTransitions>(
      "~/get_available_transitions",
      [&actor](const GetAvailableTransitions::Request&, const Tick&) {
        return to_response(lifecycle::transitions_from(actor.state));
      },
      nullptr, ServiceScope::node);
  setup.service<GetAvailableTransitions>(
      "~/get_transition_graph",
      [](const GetAvailableTransitions::Request&, const Tick&) {
        return to_response(lifecycle::transitions());
      },
      nullptr, ServiceScope::node);
}

std::function<void(const lifecycle::Transition&, Time)> offer_transition_events(Setup& setup) {
  return [events = setup.output<lifecycle_msgs::msg::TransitionEvent>("~/transition_event")](
             const lifecycle::Transition& transition, Time now) {
    lifecycle_msgs::msg::TransitionEvent event;
    event.timestamp(static_cast<std::uint64_t>(now.nanoseconds));
    event.transition(to_message(transition));
    event.start_state(to_message(transition.start));
    event.goal_state(to_message(transition.goal));
    events.publish(event);
  };
}

}  // namespace bw
