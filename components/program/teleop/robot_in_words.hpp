// What the robot says of itself, in one line for whoever drives it.
#pragma once

#include <optional>
#include <string>

#include <bandwagon_msgs/msg/base_state.hpp>

#include "runtime/base/pose2.hpp"

namespace bw {

/// Such as "STOPPED: bumper left (R releases)"; nothing is known of a robot that has said nothing.
std::string in_words(const std::optional<bandwagon_msgs::msg::BaseState>& state);
/// Such as "0.30 m/s -0.12 rad/s".
std::string in_words(const Twist2& twist);

}  // namespace bw
