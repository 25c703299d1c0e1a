// The base of the simulated world, over /sim/*. For the adaptor only.
#pragma once

#include <functional>
#include <utility>

#include <bandwagon_msgs/msg/wheel_ticks.hpp>

#include "components/messages/wheel_joints.hpp"
#include "components/robot_base/driver.hpp"
#include "runtime/component.hpp"

namespace bw {

struct SimulatedDriverOptions {
  template <class Visitor>
  void fields(Visitor&) {}
};

class SimulatedDriver final : public Driver {
 public:
  SimulatedDriver(const SimulatedDriverOptions&, const DriverContext& context)
      : radii_(context.robot.wheel_radii()), wake_(context.wake) {
    commands_ = context.setup.command<sensor_msgs::msg::JointState>("sim/wheel_commands");
    context.setup.input<bandwagon_msgs::msg::WheelTicks>(
        "sim/wheel_ticks", Qos::standard(),
        [this](const bandwagon_msgs::msg::WheelTicks& ticks, const Tick& tick) {
          readings_.counts.push_back({from_stamp(ticks.header().stamp()), ticks.left(), ticks.right()});
          wake_(tick.now);
        });
  }

  Readings poll(Time) override { return std::exchange(readings_, {}); }

  bool command(Time now, const WheelSpeeds& wheels) override {
    if (told_.is_due(wheels, now)) commands_.publish(to_joint_state(wheels, radii_, now));
    return true;
  }
  void stop(Time now) override {
    told_.forget();
    command(now, {});
  }

 private:
  WheelRadii radii_;
  std::function<void(Time now)> wake_;
  Output<sensor_msgs::msg::JointState> commands_;
  Readings readings_;
  ToldWheels told_;
};

}  // namespace bw
