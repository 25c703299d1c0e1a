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
inline sensor_msgs::msg::JointState to_joint_state(const WheelSpeeds& wheels, const WheelRadii& radii,
                                                   Time stamp) {
  sensor_msgs::msg::JointState message;
  message.header().stamp(to_stamp(stamp));
  message.name(wheel_joint_names());
  message.velocity({wheels.left / radii.left, wheels.right / radii.right});
  return message;
}

/// Ground speeds [m/s] in any order of the names; nothing unless exactly the two wheels are there.
inline std::optional<WheelSpeeds> wheel_speeds_of(const sensor_msgs::msg::JointState& message,
                                                  const WheelRadii& radii) {
  const std::vector<std::string>& names = wheel_joint_names();
  if (message.name().size() != 2 || message.velocity().size() != 2) return std::nullopt;
  const bool in_order = message.name() == names;
  if (!in_order && (message.name()[0] != names[1] || message.name()[1] != names[0])) return std::nullopt;
  const std::size_t left = in_order ? 0 : 1;
  return WheelSpeeds{message.velocity()[left] * radii.left, message.velocity()[1 - left] * radii.right};
}

/// When a device tells the wheels of the simulated world their speeds: at once when they change, and again as long as they
/// hold, since the world brakes when it hears nothing, as a motor's firmware does.
class ToldWheels {
 public:
  static constexpr Duration kAgain = Duration::milliseconds(100);

  bool is_due(const WheelSpeeds& wheels, Time now) {
    if (wheels_ == wheels && now - told_ < kAgain) return false;
    wheels_ = wheels;
    told_ = now;
    return true;
  }
  /// The next is due whatever it is.
  void forget() { wheels_.reset(); }

 private:
  std::optional<WheelSpeeds> wheels_;
  Time told_;
};

}  // namespace bw
