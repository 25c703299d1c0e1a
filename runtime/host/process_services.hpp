// What every process offers beside its components, as one more node: /clock in lock-step, /rosout,
// /parameter_events, /diagnostics, the list of what runs in it, bonds.
#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include <diagnostic_msgs/msg/diagnostic_array.hpp>
#include <rcl_interfaces/msg/log.hpp>
#include <rcl_interfaces/msg/parameter_event.hpp>
#include <rosgraph_msgs/msg/clock.hpp>

#include "runtime/component.hpp"
#include "runtime/host/actor.hpp"
#include "runtime/host/bonds.hpp"
#include "runtime/host/diagnostic_status.hpp"

namespace bw {

// Every node is said to write here: ROS 2's tools look for both at each.
inline constexpr const char* kRosout = "/rosout";
inline constexpr const char* kParameterEvents = "/parameter_events";

struct ProcessServiceOptions {
  bool publishes_clock = false;                   ///< lock-step
  std::function<void(Time)> on_clock;             ///< hears /clock, when time comes from outside; empty: deaf
  std::function<void(Time)> look_around;          ///< every half second; empty: never
  std::vector<std::string> bond_namespaces = {};  ///< where components have bonds with a manager from outside
  bool timings = true;  ///< statistics go into the diagnostics; off in lock-step, where nothing measured on a
                        ///< real clock may enter a sample
};

/// The node of a process, `process` as the graph calls it, empty for the only one. The process id is behind
/// its name on the wire, since ROS 2's tools cannot tell nodes of one name apart; logs and diagnostics, which
/// lock-step repeats to the byte, do without.
ComponentNode node_of_process(const std::string& process);

class ProcessServices final : public Component {
 public:
  ProcessServices(ProcessServiceOptions options, const std::vector<Actor*>& watched)
      : options_(std::move(options)), watched_(watched), statuses_(options_.timings), bonds_(watched) {}

  void configure(Setup& setup) override;
  /// From any thread.
  void log(const std::string& name, Time stamp, LogLevel level, const std::string& text);
  /// From any thread. `node` is a full name.
  void tell_change(const std::string& node, Time stamp, const std::vector<NamedValue>& changed);

 private:
  void publish_diagnostics(Time now);

  ProcessServiceOptions options_;
  const std::vector<Actor*>& watched_;
  DiagnosticStatuses statuses_;
  Bonds bonds_;
  Output<rosgraph_msgs::msg::Clock> clock_;
  Output<diagnostic_msgs::msg::DiagnosticArray> diagnostics_;
  std::mutex log_mutex_;
  Output<rcl_interfaces::msg::Log> rosout_;
  std::mutex event_mutex_;
  Output<rcl_interfaces::msg::ParameterEvent> parameter_events_;
};

}  // namespace bw
