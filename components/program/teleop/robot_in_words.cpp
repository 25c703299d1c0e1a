#include "components/program/teleop/robot_in_words.hpp"

#include <fmt/format.h>

namespace bw {

std::string in_words(const std::optional<bandwagon_msgs::msg::BaseState>& state) {
  namespace base = bandwagon_msgs::msg::BaseState_Constants;
  if (!state) return "no base_state is heard";
  const char* const released = state->is_latched() ? " (R releases)" : "";
  switch (state->state()) {
    case base::DRIVING:
      return state->commanded_left() == 0.0F && state->commanded_right() == 0.0F ? "standing" : "driving";
    case base::WAITING:
      return state->reason().empty() ? "standing" : "standing: " + state->reason();
    case base::BACKING_OFF:
      return "backing off: " + state->reason();
    case base::EMERGENCY_STOP:
      return fmt::format("EMERGENCY STOP{}{}{}", state->reason().empty() ? "" : ": ", state->reason(),
                         released);
    default:
      return fmt::format("STOPPED: {}{}", state->reason(), released);
  }
}

std::string in_words(const Twist2& twist) {
  return fmt::format("{:.2f} m/s {:.2f} rad/s", twist.v, twist.omega);
}

}  // namespace bw
