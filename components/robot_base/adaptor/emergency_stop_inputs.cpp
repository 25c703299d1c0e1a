#include "components/robot_base/adaptor/emergency_stop_inputs.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include <std_msgs/msg/bool.hpp>

namespace bw {
namespace {

/// It came from the wire, and goes into logs: what is no name of ROS 2 is not repeated.
std::string printable(const std::string& node) {
  constexpr std::size_t kLongest = 256;
  const auto is_of_a_name = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '/';
  };
  const bool is_name = node.size() <= kLongest && std::ranges::all_of(node, is_of_a_name);
  return is_name ? node : "somebody whose name is none";
}

}  // namespace

void EmergencyStopInputs::configure(Setup& setup) {
  log_ = setup.log();
  writers_ = &setup.writers();
  if (!setup.is_lockstep()) {
    file_ = std::make_unique<EmergencyStopFile>(setup.state_file("emergency_stop.yaml"),
                                                [this](const std::string& text) { log_.error("{}", text); });
    if (auto record = file_->read()) stop_.restore(kept_ = std::move(*record));
  }
  // A reader that wants what was said before it came does not match those who keep nothing, a reliable one
  // not those who are not: an emergency stop is heard from all of them, if twice.
  Qos best_effort = Qos::standard();
  best_effort.reliability = Reliability::best_effort;
  for (const Qos& qos : {Qos::standard(), Qos::latched(), best_effort}) {
    setup.input<std_msgs::msg::Bool>(
        "emergency_stop", qos, [this](const auto& message, const Tick& tick) { hear(message.data(), tick); },
        Need::optional);
  }
}

void EmergencyStopInputs::begin(Time now, const EmergencyStopOptions& options,
                                std::function<void(Time)> on_change) {
  has_buttons_ = !options.buttons.empty();
  stop_.begin(now, options);
  on_change_ = std::move(on_change);
  if (file_ == nullptr) return;
  if (const auto obstacle = file_->obstacle()) log_.warn("{}", *obstacle);
}

void EmergencyStopInputs::step(Time now) {
  stop_.step(now);
  keep();
}

void EmergencyStopInputs::hear(bool is_pressed, const Tick& tick) {
  const std::string reason = stop_.reason();
  const bool needs_name = is_pressed || has_buttons_;
  stop_.hear(tick.now, tick.from.writer, needs_name ? printable(writers_->node_of(tick.from.writer)) : "",
             is_pressed);
  keep();
  if (stop_.reason() == reason) return;
  if (on_change_) return on_change_(tick.now);
  log_.warn("{}; while it is not active; until release_stop", stop_.reason());
}

void EmergencyStopInputs::name() {
  stop_.name([this](const auto& writer) { return printable(writers_->node_of(writer)); });
}

void EmergencyStopInputs::keep() {
  if (stop_.record() == kept_) return;
  kept_ = stop_.record();
  if (file_) file_->keep(kept_);
}

std::optional<std::string> EmergencyStopInputs::refusal() const {
  return stop_.refusal([this](const auto& writer) { return writers_->lease_of(writer); });
}

std::string EmergencyStopInputs::release() {
  std::string said = stop_.release();
  keep();
  return said;
}

}  // namespace bw
