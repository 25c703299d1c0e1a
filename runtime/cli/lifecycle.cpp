// `bandwagon lifecycle`: what `ros2 lifecycle` does, for machines without ROS 2.
#include <algorithm>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <lifecycle_msgs/srv/change_state.hpp>
#include <lifecycle_msgs/srv/get_available_transitions.hpp>
#include <lifecycle_msgs/srv/get_state.hpp>

#include "runtime/cli/outside.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/parameters/nearest.hpp"
#include "runtime/ros/service_call.hpp"

namespace bw::cli {
namespace {

using lifecycle_msgs::srv::ChangeState;
using lifecycle_msgs::srv::GetAvailableTransitions;
using lifecycle_msgs::srv::GetState;
using Transitions = std::vector<lifecycle_msgs::msg::TransitionDescription>;

constexpr std::string_view kGetState = "/get_state";
constexpr auto kQuickAnswer = std::chrono::milliseconds(2'000);
/// A transition answers when its work is done.
constexpr auto kTransition = std::chrono::milliseconds(30'000);

struct LifecycleOptions {
  std::string node;
  std::string transition;
  bool all = false;
};

/// Nodes that have a lifecycle: they offer get_state of that type.
std::vector<std::string> managed_nodes(const Outside& outside) {
  std::vector<std::string> nodes;
  for (const dds::Endpoint& end : outside.endpoints(true)) {
    const std::string service = service_of_request(end.topic);
    const bool is_ours =
        !end.is_writer && service.ends_with(kGetState) && end.type.starts_with("lifecycle_msgs::");
    if (is_ours) nodes.push_back(service.substr(0, service.size() - kGetState.size()));
  }
  std::ranges::sort(nodes);
  nodes.erase(std::ranges::unique(nodes).begin(), nodes.end());
  return nodes;
}

/// The full name behind what was typed; throws when there is no such node.
std::string managed_node(Outside& outside, const std::string& typed) {
  const std::string name = typed.starts_with('/') ? typed : "/" + typed;
  std::vector<std::string> nodes;
  outside.settle([&] {
    nodes = managed_nodes(outside);
    return std::ranges::find(nodes, name) != nodes.end();
  });
  if (std::ranges::find(nodes, name) != nodes.end()) return name;
  const std::vector<std::string_view> known(nodes.begin(), nodes.end());
  throw std::runtime_error(name + ": " + unknown_rule("node with a lifecycle", name, known));
}

template <class S>
typename S::Response ask(Outside& outside, const std::string& node, std::string_view service,
                         const typename S::Request& request, std::chrono::milliseconds limit = kQuickAnswer) {
  const auto response = call_service<S>(outside.participant(), node + std::string(service), request, limit);
  if (!response)
    throw std::runtime_error(fmt::format("{}{} did not answer within {} s", node, service,
                                         std::chrono::duration<double>(limit).count()));
  return *response;
}

std::string state_of(Outside& outside, const std::string& node) {
  const auto state = ask<GetState>(outside, node, kGetState, {}).current_state();
  return fmt::format("{} [{}]", state.label(), state.id());
}

void nodes() {
  Outside outside;
  outside.settle();
  for (const std::string& node : managed_nodes(outside)) std::cout << node << "\n";
}

void get(const LifecycleOptions& options) {
  Outside outside;
  if (!options.node.empty()) {
    std::cout << state_of(outside, managed_node(outside, options.node)) << "\n";
    return;
  }
  outside.settle();
  for (const std::string& node : managed_nodes(outside))
    std::cout << node << ": " << state_of(outside, node) << "\n";
}

Transitions transitions(Outside& outside, const std::string& node, bool all) {
  const std::string_view service = all ? "/get_transition_graph" : "/get_available_transitions";
  return ask<GetAvailableTransitions>(outside, node, service, {}).available_transitions();
}

void list(const LifecycleOptions& options) {
  Outside outside;
  const std::string node = managed_node(outside, options.node);
  for (const auto& t : transitions(outside, node, options.all)) {
    std::cout << fmt::format("- {} [{}]\n\tStart: {}\n\tGoal: {}\n", t.transition().label(),
                             t.transition().id(), t.start_state().label(), t.goal_state().label());
  }
}

int set(const LifecycleOptions& options) {
  Outside outside;
  const std::string node = managed_node(outside, options.node);
  const Transitions available = transitions(outside, node, false);
  const auto wanted = std::ranges::find_if(available, [&](const auto& t) {
    return t.transition().label() == options.transition ||
           std::to_string(t.transition().id()) == options.transition;
  });
  if (wanted == available.end()) {
    std::string names;
    for (const auto& t : available) names += (names.empty() ? "" : ", ") + t.transition().label();
    throw std::runtime_error(fmt::format("{} has no transition {} now; it has: {}", node, options.transition,
                                         names.empty() ? "none" : names));
  }
  ChangeState::Request request;
  request.transition(wanted->transition());
  if (!ask<ChangeState>(outside, node, "/change_state", request, kTransition).success()) {
    std::cerr << "Transitioning failed: " << node << " is " << state_of(outside, node) << "\n";
    return 1;
  }
  std::cout << "Transitioning successful\n";
  return 0;
}

void add_lifecycle(Verb lifecycle) {
  auto options = std::make_shared<LifecycleOptions>();
  lifecycle.verb("nodes", "Nodes that have a lifecycle").run([] { nodes(); });
  Verb get_verb = lifecycle.verb("get", "State of a node, or of all");
  get_verb.option("NODE", options->node, "Full name");
  get_verb.run([options] { get(*options); });
  Verb list_verb = lifecycle.verb("list", "Transitions that a node has now");
  list_verb.option("NODE", options->node, "Full name").required();
  list_verb.flag("-a,--all", options->all, "The whole graph of transitions");
  list_verb.run([options] { list(*options); });
  Verb set_verb = lifecycle.verb("set", "Asks a node for a transition; exit status 1 when it failed");
  set_verb.option("NODE", options->node, "Full name").required();
  set_verb
      .option("TRANSITION", options->transition,
              "configure, activate, deactivate, cleanup, shutdown, or its number")
      .required();
  set_verb.run([options] { return set(*options); });
}

}  // namespace

BW_VERB(look, "lifecycle", "States of managed nodes", add_lifecycle)

}  // namespace bw::cli
