// The base of the simulated world, over /sim/*. For the adaptor only.
#pragma once

#include <utility>

#include <bandwagon_msgs/msg/wheel_ticks.hpp>

#include "components/messages/wheel_joints.hpp"
#include "components/robot_base/driver.hpp"
#include "runtime/component.hpp"

namespace bw {

class SimulatedDriver final : public Driver {
 public:
  SimulatedDriver(Setup& setup, double wheel_radius) : wheel_radius_(wheel_radius) {
    commands_ = setup.command<sensor_msgs::msg::JointState>("sim/wheel_commands");
    setup.input<bandwagon_msgs::msg::WheelTicks>(
        "sim/wheel_ticks", Qos::standard(),
        [this](const bandwagon_msgs::msg::WheelTicks& ticks, const Tick&) {
          if (sink_) sink_({from_stamp(ticks.header().stamp()), ticks.left(), ticks.right()});
        });
  }

  void command(Time now, const WheelSpeeds& wheels) override {
    commands_.publish(to_joint_state(wheels, wheel_radius_, now));
  }
  void deliver_counts_to(OnCounts sink) override { sink_ = std::move(sink); }

 private:
  double wheel_radius_;
  Output<sensor_msgs::msg::JointState> commands_;
  OnCounts sink_;
};

}  // namespace bw
