#include "components/robot_base/emergency_stop.hpp"

#include <algorithm>

namespace bw {
namespace {

constexpr std::size_t kMaxNames = 5;  // in one sentence

std::string name_of(const std::string& node) { return node.empty() ? "somebody without a node name" : node; }

/// Each name once.
std::string names_of(const std::vector<EmergencyStop::Pressed>& pressed) {
  std::vector<std::string> names;
  for (const auto& button : pressed) {
    if (std::ranges::find(names, name_of(button.node)) == names.end()) names.push_back(name_of(button.node));
  }
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMaxNames); ++i) text += (i == 0 ? "" : ", ") + names[i];
  if (names.size() > kMaxNames) text += " and " + std::to_string(names.size() - kMaxNames) + " more";
  return text;
}

/// A process that was killed has said nothing, and is taken for gone when its lease is over.
std::string told_lease(Duration lease) {
  if (lease <= Duration{}) return "";
  if (lease >= Duration::seconds(3600.0))
    return "; one that was killed counts as there until this base is started anew";
  const std::int64_t seconds = (lease.nanoseconds + 999'999'999) / 1'000'000'000;
  return "; one that was killed counts as there for " + std::to_string(seconds) + " s after that";
}

}  // namespace

std::optional<std::string> EmergencyStopOptions::violated_rule() const {
  for (auto button = buttons.begin(); button != buttons.end(); ++button) {
    if (!button->node.starts_with('/'))
      return "buttons must have full names, such as /panel: " + button->node;
    const auto is_same = [&](const StopButtonOptions& other) { return other.node == button->node; };
    if (std::any_of(buttons.begin(), button, is_same))
      return "buttons must differ: " + button->node + " is there twice";
  }
  return std::nullopt;
}

void EmergencyStop::begin(Time now, const EmergencyStopOptions& options) {
  buttons_.clear();
  for (const StopButtonOptions& button : options.buttons) buttons_.push_back({button, now});
}

void EmergencyStop::hear(Time now, const Writer& writer, const std::string& node, bool is_pressed) {
  for (Button& button : buttons_) {
    if (button.options.node == node) button.heard = now;
  }
  const auto own = std::ranges::find(record_.pressed, writer, &Pressed::writer);
  if (!is_pressed) {
    if (own == record_.pressed.end()) return;
    record_.cause = "the emergency stop was pressed by " + name_of(own->node);
    record_.pressed.erase(own);
    return;
  }
  if (own != record_.pressed.end()) return;
  record_.pressed.push_back({writer, node, now});
  record_.cause = "the emergency stop was pressed by " + name_of(node);
}

void EmergencyStop::step(Time now) {
  for (Button& button : buttons_) {
    button.heard = std::min(button.heard, now);  // the clock went back
    button.is_silent = now - button.heard > Duration::seconds(button.options.heartbeat);
    if (button.is_silent) record_.cause = "the emergency stop button " + button.options.node + " is silent";
  }
}

void EmergencyStop::name(const NodeOf& node_of) {
  for (Pressed& button : record_.pressed) {
    if (!button.node.empty()) continue;
    button.node = node_of(button.writer);
    if (!button.node.empty()) record_.cause = "the emergency stop was pressed by " + button.node;
  }
}

std::string EmergencyStop::reason() const {
  if (record_.pressed.empty()) return record_.cause;
  return "the emergency stop is pressed by " + names_of(record_.pressed);
}

std::optional<std::string> EmergencyStop::refusal(const LeaseOf& lease_of) const {
  std::vector<Pressed> there;
  Duration longest;
  for (const Pressed& button : record_.pressed) {
    const std::optional<Duration> lease = lease_of(button.writer);
    if (lease) there.push_back(button);
    longest = std::max(longest, lease.value_or(Duration{}));
  }
  if (!there.empty()) return "the emergency stop is pressed by " + names_of(there) + told_lease(longest);
  const auto silent = std::ranges::find(buttons_, true, &Button::is_silent);
  if (silent == buttons_.end()) return std::nullopt;
  return "the emergency stop button " + silent->options.node + " is silent";
}

std::string EmergencyStop::release() {
  const bool has_left = !record_.pressed.empty();
  std::string text = has_left ? names_of(record_.pressed) + " pressed the emergency stop and has left" : "";
  record_ = {};
  return text;
}

}  // namespace bw
