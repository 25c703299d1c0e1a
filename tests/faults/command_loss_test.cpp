// Commands stop at top speed, in virtual time: the contract of motor_control (command age 200 ms, steps of 20
// ms) and of robot_base (watchdog 200 ms, checked every 10 ms). Standstill: 1 m/s at 2 m/s^2 is 0.5 s after
// that.
#include <filesystem>
#include <fstream>
#include <optional>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <geometry_msgs/msg/twist.hpp>
#include <gtest/gtest.h>
#include <sensor_msgs/msg/joint_state.hpp>

#include "components/model/robot.hpp"
#include "runtime/host/host.hpp"
#include "runtime/stamps.hpp"

namespace bw {
namespace {

constexpr double kLastCommand = 5.0;  // [s] after the start of the run

/// Speed of the robot over time, seen by a component that also sends commands until kLastCommand.
struct Drive {
  std::optional<double> braking_at;
  std::optional<double> standing_at;
  double top_speed = 0.0;
};

class Observer : public Component {
 public:
  explicit Observer(Drive& drive) : drive_(drive) {}
  void configure(Setup& setup) override {
    setup.input<bandwagon_msgs::msg::GroundTruth>(
        "sim/ground_truth", Qos::command(), [this](const auto& truth, const Tick& tick) {
          if (!start_) start_ = tick.now;
          see((tick.now - *start_).to_seconds(), truth.twist().linear().x());
        });
  }

 protected:
  bool still_commanding(const Tick& tick) {
    if (!start_) start_ = tick.now;
    return (tick.now - *start_).to_seconds() <= kLastCommand;
  }

 private:
  void see(double t, double v) {
    if (t <= kLastCommand) drive_.top_speed = std::max(drive_.top_speed, v);
    if (t <= kLastCommand) return;
    if (!drive_.braking_at && v < drive_.top_speed - 0.02) drive_.braking_at = t - kLastCommand;
    if (!drive_.standing_at && v < 0.001) drive_.standing_at = t - kLastCommand;
  }

  Drive& drive_;
  std::optional<Time> start_;
};

/// Sends 1 m/s on cmd_vel at 10 Hz, as a local planner does.
class CmdVelSource final : public Observer {
 public:
  using Observer::Observer;
  void configure(Setup& setup) override {
    Observer::configure(setup);
    setup.every(Duration::milliseconds(100), "commands",
                [this, out = setup.command<geometry_msgs::msg::Twist>("cmd_vel")](const Tick& tick) {
                  geometry_msgs::msg::Twist twist;
                  twist.linear().x(1.0);
                  if (still_commanding(tick)) out.publish(twist);
                });
  }
};

/// Sends wheel rates for 1 m/s at 50 Hz, as motor_control does.
class WheelSource final : public Observer {
 public:
  using Observer::Observer;
  void configure(Setup& setup) override {
    Observer::configure(setup);
    const auto robot = setup.shared<Robot>("robot");
    setup.every(Duration::milliseconds(20), "commands",
                [this, rate = 1.0 / robot.wheel_radius,
                 out = setup.command<sensor_msgs::msg::JointState>("wheel_commands")](const Tick& tick) {
                  sensor_msgs::msg::JointState joints;
                  joints.header().stamp(to_stamp(tick.now));
                  joints.name({"left_wheel_joint", "right_wheel_joint"});
                  joints.velocity({rate, rate});
                  if (still_commanding(tick)) out.publish(joints);
                });
  }
};

Drive drive(const std::string& components, std::unique_ptr<Component> (*make_source)(Drive&)) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "command_loss.yaml";
  std::ofstream(path) << "robot: {limits: {v_max: 1.0, acc_max: 1.0, stop_deceleration: 2.0}}\ncomponents:\n"
                      << "  world: {parameters: {truth_rate: 100.0}}\n"
                      << components;
  Drive result;
  std::vector<ExtraComponent> extra;
  extra.push_back({"source", make_source(result)});
  Host host(load_graph(path), {.clock = ClockMode::lockstep, .seed = 5}, std::move(extra));
  host.run(Duration::seconds(kLastCommand + 2.0));
  return result;
}

void expect_stop(const Drive& drive, double latest_braking, double latest_standing) {
  EXPECT_NEAR(drive.top_speed, 1.0, 0.05);
  ASSERT_TRUE(drive.braking_at && drive.standing_at);
  EXPECT_LE(*drive.braking_at, latest_braking);
  EXPECT_LE(*drive.standing_at, latest_standing);
}

TEST(CommandLoss, MotorControlBrakesWhenTheVelocityCommandIsOlderThan200Ms) {
  // 200 ms age + 20 ms step + 10 ms physics + 10 ms until 0.02 m/s are lost
  expect_stop(drive("  robot_base: {}\n  motor_control: {}\n",
                    [](Drive& d) -> std::unique_ptr<Component> { return std::make_unique<CmdVelSource>(d); }),
              0.26, 1.0);
}

TEST(CommandLoss, TheBaseBrakesByItselfWhenWheelCommandsStop) {
  // 200 ms watchdog + 10 ms check + 10 ms physics + 10 ms until 0.02 m/s are lost
  expect_stop(drive("  robot_base: {}\n",
                    [](Drive& d) -> std::unique_ptr<Component> { return std::make_unique<WheelSource>(d); }),
              0.25, 1.0);
}

}  // namespace
}  // namespace bw
