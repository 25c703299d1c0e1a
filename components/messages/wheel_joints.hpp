// Wheel speeds as joints: sensor_msgs/JointState with the names every differential-drive robot description
// uses. For adaptors only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <sensor_msgs/msg/joint_state.hpp>

#include "components/model/differential_drive.hpp"
#include "runtime/stamps.hpp"

namespace bw {

inline const std::vector<std::string>& wheel_joint_names() {
  static const std::vector<std::string> names{"left_wheel_joint", "right_wheel_joint"};
  return names;
}

/// `wheels` are ground speeds [m/s]; the message holds rates [rad/s].
inline sensor_msgs::msg::JointState to_joint_state(const WheelSpeeds& wheels, double wheel_radius,
                                                   Time stamp) {
  sensor_msgs::msg::JointState message;
  message.header().stamp(to_stamp(stamp));
  message.name(wheel_joint_names());
  message.velocity({wheels.left / wheel_radius, wheels.right / wheel_radius});
  return message;
}

/// Ground speeds [m/s] in any order of the names; nothing unless exactly the two wheels are there.
inline std::optional<WheelSpeeds> wheel_speeds_of(const sensor_msgs::msg::JointState& message,
                                                  double wheel_radius) {
  const std::vector<std::string>& names = wheel_joint_names();
  if (message.name().size() != 2 || message.velocity().size() != 2) return std::nullopt;
  const bool in_order = message.name() == names;
  if (!in_order && (message.name()[0] != names[1] || message.name()[1] != names[0])) return std::nullopt;
  const double first = message.velocity()[0] * wheel_radius;
  const double second = message.velocity()[1] * wheel_radius;
  return in_order ? WheelSpeeds{first, second} : WheelSpeeds{second, first};
}

}  // namespace bw
