#include <algorithm>
#include <cmath>
#include <numbers>

#include <bandwagon_msgs/msg/wheel_ticks.hpp>
#include <gtest/gtest.h>
#include <nav_msgs/msg/odometry.hpp>
#include <sensor_msgs/msg/joint_state.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include "components/messages/geometry.hpp"
#include "components/messages/wheel_joints.hpp"
#include "tests/components/component_rig.hpp"

namespace bw {
namespace {

constexpr double kRadius = 0.0762;  // wheel of the default robot [m]

struct Sent {
  double time;
  WheelSpeeds wheels;
};

/// Wheels without mass: they rotate as they are told, and count it every 10 ms.
class Wheels {
 public:
  void declare(Setup& setup, std::vector<Sent>& sent) {
    setup.input<sensor_msgs::msg::JointState>(
        "sim/wheel_commands", Qos::standard(50), [&](const auto& m, const Tick& tick) {
          told_ = wheel_speeds_of(m, {kRadius, kRadius}).value_or(WheelSpeeds{-9, -9});
          sent.push_back({seconds_since_start(tick.now), told_});
        });
    setup.every(Duration::milliseconds(10), "wheels",
                [this, out = setup.output<bandwagon_msgs::msg::WheelTicks>("sim/wheel_ticks")](
                    const Tick& tick) mutable {
                  constexpr double kTicksPerMetre = 2578.0 / (2.0 * std::numbers::pi * kRadius);
                  left_ += told_.left * 0.01 * kTicksPerMetre;
                  right_ += told_.right * 0.01 * kTicksPerMetre;
                  bandwagon_msgs::msg::WheelTicks message;
                  message.header().stamp(to_stamp(tick.now));
                  message.left(static_cast<std::int32_t>(left_));
                  message.right(static_cast<std::int32_t>(right_));
                  out.publish(message);
                });
  }

 private:
  WheelSpeeds told_;
  double left_ = 0.0, right_ = 0.0;
};

/// Wheel commands of 1 m/s every 20 ms until `last` [s]; what the driver got.
std::vector<Sent> drive_until(double last, const sensor_msgs::msg::JointState& command) {
  std::vector<Sent> sent;
  Wheels wheels;
  run_with_script("components: {robot_base: {}}", 3.0, [&](bw::Setup& setup) {
    wheels.declare(setup, sent);
    setup.every(
        Duration::milliseconds(20), "drive",
        [=, out = setup.command<sensor_msgs::msg::JointState>("wheel_commands")](const Tick& tick) mutable {
          if (seconds_since_start(tick.now) <= last + 1e-9) out.publish(command);
        });
  });
  return sent;
}

TEST(RobotBaseComponent, BrakesWithin210MsOfTheLastCommand) {
  const std::vector<Sent> sent = drive_until(1.0, to_joint_state({1.0, 1.0}, {kRadius, kRadius}, {}));
  const auto full =
      std::find_if(sent.begin(), sent.end(), [](const Sent& s) { return s.wheels.left > 0.999; });
  ASSERT_NE(full, sent.end());
  EXPECT_NEAR(full->time, 0.02 + 1.0, 1e-9);  // from the first command on with acc_max, 1 m/s^2
  const auto braking = std::find_if(full, sent.end(), [](const Sent& s) { return s.wheels.left < 0.999; });
  ASSERT_NE(braking, sent.end());
  EXPECT_GE(braking->time, 1.20 - 1e-9);
  EXPECT_LE(braking->time, 1.21 + 1e-9);
  const auto rest = std::find_if(full, sent.end(), [](const Sent& s) { return s.wheels == WheelSpeeds{}; });
  ASSERT_NE(rest, sent.end());
  EXPECT_NEAR(rest->time - braking->time, 0.49, 1e-6);  // 1 m/s at 2 m/s^2, counted from 0.2 s of age on
}

TEST(RobotBaseComponent, RefusesCommandsThatAreNotTwoFiniteRates) {
  sensor_msgs::msg::JointState nameless = to_joint_state({1.0, 1.0}, {kRadius, kRadius}, {});
  nameless.name({});
  sensor_msgs::msg::JointState nan = to_joint_state({std::nan(""), 1.0}, {kRadius, kRadius}, {});
  for (const auto& command : {nameless, nan}) {
    for (const Sent& s : drive_until(1.0, command)) EXPECT_EQ(s.wheels, WheelSpeeds{});
  }
}

TEST(RobotBaseComponent, TakesTheWheelsByName) {
  sensor_msgs::msg::JointState swapped;
  swapped.name({"right_wheel_joint", "left_wheel_joint"});
  swapped.velocity({2.0, 1.0});
  const std::vector<Sent> sent = drive_until(0.5, swapped);
  // What is told does not change from the end of the ramp, 0.15 s, until commands are too old.
  const auto settled = std::find_if(sent.rbegin(), sent.rend(), [](const Sent& s) { return s.time < 0.6; });
  ASSERT_NE(settled, sent.rend());
  EXPECT_NEAR(settled->wheels.left, kRadius, 1e-12);
  EXPECT_NEAR(settled->wheels.right, 2.0 * kRadius, 1e-12);
}

TEST(RobotBaseComponent, PublishesOdometryJointsAndTransformOfEveryReading) {
  std::vector<nav_msgs::msg::Odometry> odometry;
  sensor_msgs::msg::JointState joints;
  tf2_msgs::msg::TFMessage tf;
  run_with_script("components: {robot_base: {}}", 2.0, [&](bw::Setup& setup) {
    setup.command<sensor_msgs::msg::JointState>("wheel_commands");
    setup.input<nav_msgs::msg::Odometry>("odom", Qos::standard(50),
                                         [&](const auto& m, const Tick&) { odometry.push_back(m); });
    setup.input<sensor_msgs::msg::JointState>("joint_states", Qos::standard(50),
                                              [&](const auto& m, const Tick&) { joints = m; });
    setup.input<tf2_msgs::msg::TFMessage>("/tf", Qos::tf(), [&](const auto& m, const Tick&) { tf = m; });
    setup.every(Duration::milliseconds(20), "ticks",
                [out = setup.output<bandwagon_msgs::msg::WheelTicks>("sim/wheel_ticks"),
                 n = 0](const Tick& tick) mutable {
                  bandwagon_msgs::msg::WheelTicks message;
                  message.header().stamp(to_stamp(tick.now));
                  message.left(n * 40);
                  message.right(n * 50);
                  ++n;
                  out.publish(message);
                });
  });
  ASSERT_EQ(odometry.size(), 100U);
  // 99 steps of 40 and 50 ticks: an arc of length s and rotation phi.
  const double tick = 2.0 * std::numbers::pi * kRadius / 2578.0;
  const double s = 99 * 45 * tick;
  const double phi = 99 * 10 * tick / 0.39;
  const Pose2 X_OB = from_pose(odometry.back().pose().pose());
  EXPECT_NEAR(X_OB.x, s / phi * std::sin(phi), 1e-9);
  EXPECT_NEAR(X_OB.y, s / phi * (1.0 - std::cos(phi)), 1e-9);
  EXPECT_NEAR(X_OB.theta, phi, 1e-9);
  EXPECT_EQ(odometry.back().header().frame_id(), "odom");
  EXPECT_EQ(odometry.back().child_frame_id(), "base_link");
  EXPECT_NEAR(odometry.back().twist().twist().linear().x(), 45 * tick / 0.02, 1e-9);
  EXPECT_GT(odometry.back().pose().covariance()[35], 0.0);
  ASSERT_EQ(joints.position().size(), 2U);
  EXPECT_NEAR(joints.position()[0], 99 * 40 * tick / kRadius, 1e-9);
  ASSERT_EQ(tf.transforms().size(), 1U);
  EXPECT_EQ(tf.transforms()[0].child_frame_id(), "base_link");
  EXPECT_NEAR(tf.transforms()[0].transform().translation().x(), X_OB.x, 1e-12);
}

}  // namespace
}  // namespace bw
