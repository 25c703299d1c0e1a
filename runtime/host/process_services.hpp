// What every process offers beside its components, as one more node: /clock in lock-step, /rosout,
// /diagnostics.
#pragma once

#include <mutex>

#include <diagnostic_msgs/msg/diagnostic_array.hpp>
#include <rcl_interfaces/msg/log.hpp>
#include <rosgraph_msgs/msg/clock.hpp>

#include "runtime/component.hpp"
#include "runtime/host/actor.hpp"

namespace bw {

class ProcessServices final : public Component {
 public:
  /// `timings`: statistics go into the diagnostics. Off in lock-step, where nothing measured on a real clock
  /// may enter a sample.
  ProcessServices(bool publishes_clock, bool timings, const std::vector<Actor*>& watched)
      : publishes_clock_(publishes_clock), timings_(timings), watched_(watched) {}

  void configure(Setup& setup) override;
  /// From any thread.
  void log(const std::string& name, Time stamp, LogLevel level, const std::string& text);

 private:
  void publish_diagnostics(Time now);

  bool publishes_clock_;
  bool timings_;
  const std::vector<Actor*>& watched_;
  Output<rosgraph_msgs::msg::Clock> clock_;
  Output<diagnostic_msgs::msg::DiagnosticArray> diagnostics_;
  std::mutex log_mutex_;
  Output<rcl_interfaces::msg::Log> rosout_;
};

}  // namespace bw
