#include "runtime/host/process_services.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "runtime/host/container_services.hpp"
#include "runtime/ros/parameter_messages.hpp"
#include "runtime/stamps.hpp"

namespace bw {
namespace {

void add_value(diagnostic_msgs::msg::DiagnosticStatus& status, std::string key, std::string value) {
  diagnostic_msgs::msg::KeyValue pair;
  pair.key(std::move(key));
  pair.value(std::move(value));
  status.values().push_back(std::move(pair));
}

void add_statistics(diagnostic_msgs::msg::DiagnosticStatus& status, const CallbackStatistics& s) {
  add_value(status, s.callback,
            fmt::format("calls {} missed {} run p50 {:.3f} p99 {:.3f} max {:.3f} ms wait p50 {:.3f} p99 "
                        "{:.3f} max {:.3f} ms",
                        s.run.count(), s.missed, s.run.quantile_ms(0.5), s.run.quantile_ms(0.99),
                        s.run.max().to_seconds() * 1e3, s.wait.quantile_ms(0.5), s.wait.quantile_ms(0.99),
                        s.wait.max().to_seconds() * 1e3));
}

void add_callbacks(diagnostic_msgs::msg::DiagnosticStatus& status, const Actor& actor, bool timings) {
  for (const auto& input : actor.inputs) {
    if (input->statistics.rejected > 0) {
      add_value(status, input->name, fmt::format("{} samples rejected", input->statistics.rejected));
    }
    if (timings && input->kind == InputKind::callback) add_statistics(status, input->statistics);
  }
  if (!timings) return;
  for (const auto& timer : actor.timers) add_statistics(status, timer->statistics);
}

}  // namespace

void ProcessServices::configure(Setup& setup) {
  rosout_ = setup.output<rcl_interfaces::msg::Log>("/rosout", Qos::rosout());
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
    if (actor->role == ActorRole::manager) continue;
    // In lock-step a run is the same whoever looks on.
    if (!options_.timings && actor->is_onlooker()) continue;
    const std::lock_guard lock(actor->mutex);
    diagnostic_msgs::msg::DiagnosticStatus status;
    status.name(actor->name);
    status.level(static_cast<std::uint8_t>(actor->diagnostic_level));
    status.message(actor->diagnostic_message);
    if (!actor->is_active()) {
      status.level(std::max(status.level(), static_cast<std::uint8_t>(DiagnosticReporter::Level::warn)));
      status.message(std::string(lifecycle::label(actor->state)));
      message.status().push_back(std::move(status));
      continue;
    }
    for (const auto& [key, value] : actor->diagnostic_values) add_value(status, key, value);
    for (const std::string& input : actor->stale_inputs(now)) {
      add_value(status, input, "stale");
      status.level(static_cast<std::uint8_t>(DiagnosticReporter::Level::error));
      status.message("input " + input + " is stale");
    }
    add_callbacks(status, *actor, options_.timings);
    message.status().push_back(std::move(status));
  }
  diagnostics_.publish(message);
}

}  // namespace bw
