#include "runtime/host/process_services.hpp"

#include <algorithm>
#include <cctype>

#include <unistd.h>

#include "runtime/host/container_services.hpp"
#include "runtime/ros/parameter_messages.hpp"
#include "runtime/stamps.hpp"

namespace bw {

ComponentNode node_of_process(const std::string& process) {
  std::string name = process.empty() ? "bandwagon" : "bandwagon_" + process;
  // A node name may hold letters, digits and underscores only; a process name anything.
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return {.name = name, .lane = "services", .node = name + "_" + std::to_string(getpid())};
}

void ProcessServices::configure(Setup& setup) {
  rosout_ = setup.output<rcl_interfaces::msg::Log>(kRosout, Qos::rosout());
  parameter_events_ =
      setup.output<rcl_interfaces::msg::ParameterEvent>(kParameterEvents, Qos::standard(1000));
  diagnostics_ = setup.output<diagnostic_msgs::msg::DiagnosticArray>("/diagnostics");
  setup.every(Duration::milliseconds(1000), "diagnostics",
              [this](const Tick& tick) { publish_diagnostics(tick.now); });
  if (options_.look_around) {
    setup.every(Duration::milliseconds(500), "look_around",
                [this](const Tick& tick) { options_.look_around(tick.now); });
  }
  if (options_.on_clock) {
    setup.input<rosgraph_msgs::msg::Clock>("/clock", Qos::clock(), [this](const auto& message, const Tick&) {
      options_.on_clock(from_stamp(message.clock()));
    });
  }
  offer_container_services(setup, watched_);
  if (!options_.bond_namespaces.empty()) bonds_.configure(setup, options_.bond_namespaces);
  if (!options_.publishes_clock) return;
  clock_ = setup.output<rosgraph_msgs::msg::Clock>("/clock");
  setup.every(Duration::milliseconds(10), "clock", [this](const Tick& tick) {
    rosgraph_msgs::msg::Clock message;
    message.clock(to_stamp(tick.now));
    clock_.publish(message);
  });
}

void ProcessServices::log(const std::string& name, Time stamp, LogLevel level, const std::string& text) {
  rcl_interfaces::msg::Log message;
  message.stamp(to_stamp(stamp));
  message.level(static_cast<std::uint8_t>(level));
  message.name(name);
  message.msg(text);
  const std::lock_guard lock(log_mutex_);
  rosout_.publish(message);
}

void ProcessServices::tell_change(const std::string& node, Time stamp,
                                  const std::vector<NamedValue>& changed) {
  rcl_interfaces::msg::ParameterEvent message;
  message.stamp(to_stamp(stamp));
  message.node(node);
  for (const NamedValue& parameter : changed) message.changed_parameters().push_back(to_message(parameter));
  const std::lock_guard lock(event_mutex_);
  parameter_events_.publish(message);
}

void ProcessServices::publish_diagnostics(Time now) {
  diagnostic_msgs::msg::DiagnosticArray message;
  message.header().stamp(to_stamp(now));
  for (const Actor* actor : watched_) {
    // In lock-step a run is the same whoever looks on.
    const bool is_left_out = actor->role == ActorRole::manager || (!options_.timings && actor->is_onlooker());
    if (!is_left_out) message.status().push_back(statuses_.of(*actor, now));
  }
  diagnostics_.publish(message);
}

}  // namespace bw
