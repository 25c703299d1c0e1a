// What measurements of a base in real time have in common: who commands its wheels, and what the process has
// cost.
#pragma once

#include <sys/resource.h>

#include "components/messages/wheel_joints.hpp"
#include "components/model/robot.hpp"
#include "runtime/host/host.hpp"

namespace bw {

/// motor_control's part: 50 commands a second.
class Commander final : public Component {
 public:
  explicit Commander(const WheelSpeeds& wheels) : wheels_(wheels) {}
  void configure(Setup& setup) override {
    const WheelRadii radii = setup.shared<Robot>("robot").wheel_radii();
    setup.every(
        Duration::milliseconds(20), "commands",
        [wheels = wheels_, radii, out = setup.command<sensor_msgs::msg::JointState>("wheel_commands")](
            const Tick& tick) mutable { out.publish(to_joint_state(wheels, radii, tick.now)); });
  }

 private:
  WheelSpeeds wheels_;
};

/// Of this process, user and system [s].
inline double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

}  // namespace bw
