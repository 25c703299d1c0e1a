// The other end of the trolley's cable, in lock-step: its board, with the wheels of the simulated world.
#include <cstdio>
#include <string>
#include <vector>

#include <bandwagon_msgs/msg/wheel_ticks.hpp>
#include <runtime/component.hpp>
#include <sensor_msgs/msg/joint_state.hpp>
#include <std_msgs/msg/u_int8_multi_array.hpp>

using bandwagon_msgs::msg::WheelTicks;
using sensor_msgs::msg::JointState;
using std_msgs::msg::UInt8MultiArray;

class TrolleyBoard final : public bw::Component {
  void configure(bw::Setup& setup) override {
    wheels_ = setup.command<JointState>("sim/wheel_commands");
    cable_ = setup.output<UInt8MultiArray>("sim/base/from_device", bw::Qos::standard(1000));
    setup.input<UInt8MultiArray>("sim/base/to_device", bw::Qos::standard(1000),
                                 [this](const UInt8MultiArray& bytes, const bw::Tick&) { obey(bytes); });
    setup.input<WheelTicks>(
        "sim/wheel_ticks", bw::Qos::standard(), [this](const WheelTicks& ticks, const bw::Tick&) {
          const std::string line =
              "T " + std::to_string(ticks.left()) + " " + std::to_string(ticks.right()) + "\n";
          UInt8MultiArray message;
          message.data().assign(line.begin(), line.end());
          cable_.publish(message);
        });
  }

  void obey(const UInt8MultiArray& bytes) {
    const std::string line(bytes.data().begin(), bytes.data().end());
    double left = 0.0, right = 0.0;
    if (std::sscanf(line.c_str(), "V %lf %lf", &left, &right) != 2) return;
    JointState message;
    message.name({"left_wheel_joint", "right_wheel_joint"});
    message.velocity({left / 1e3, right / 1e3});
    wheels_.publish(message);
  }

  bw::Output<JointState> wheels_;
  bw::Output<UInt8MultiArray> cable_;
};

BW_COMPONENT(TrolleyBoard, "trolley_board")
