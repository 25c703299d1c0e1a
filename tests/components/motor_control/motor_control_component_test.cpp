#include <cmath>

#include <geometry_msgs/msg/twist.hpp>
#include <gtest/gtest.h>
#include <nav2_msgs/msg/speed_limit.hpp>
#include <std_msgs/msg/bool.hpp>

#include "components/messages/geometry.hpp"
#include "components/messages/wheel_joints.hpp"
#include "tests/components/component_rig.hpp"
#include "tests/components/transitions.hpp"

namespace bw {
namespace {

constexpr double kRadius = 0.0762;  // wheel of the default robot [m]

/// Forward speeds commanded to the wheels, every 20 ms from 0.02 s on, when /cmd_vel follows `wish` at 10 Hz.
std::vector<double> speeds(
    double seconds, const std::function<std::optional<Twist2>(double t)>& wish,
    const std::function<std::optional<double>(double t)>& limit =
        [](double) { return std::optional<double>(); },
    const std::vector<std::pair<double, std::string>>& transitions = {}) {
  std::vector<double> list;
  run_with_script("components: {motor_control: {}}", seconds, [&](bw::Setup& setup) {
    change_states(setup, "motor_control", transitions);
    setup.input<sensor_msgs::msg::JointState>(
        "wheel_commands", Qos::standard(50), [&](const auto& m, const Tick&) {
          const WheelSpeeds wheels = wheel_speeds_of(m, {kRadius, kRadius}).value();
          list.push_back((wheels.left + wheels.right) / 2.0);
        });
    setup.every(Duration::milliseconds(100), "wish",
                [&, out = setup.command<geometry_msgs::msg::Twist>("cmd_vel"),
                 limits = setup.output<nav2_msgs::msg::SpeedLimit>("speed_limit")](const Tick& tick) mutable {
                  if (const auto most = limit(seconds_since_start(tick.now))) {
                    nav2_msgs::msg::SpeedLimit message;
                    message.speed_limit(*most);
                    limits.publish(message);
                  }
                  if (const auto twist = wish(seconds_since_start(tick.now)))
                    out.publish(to_twist_message(*twist));
                });
  });
  return list;
}

double at(const std::vector<double>& list, double t) {
  return list.at(static_cast<std::size_t>(std::lround(t / 0.02)) - 1);
}

TEST(MotorControlComponent, ReachesTheCommandAndStopsWhenCommandsStop) {
  const auto list = speeds(4.0, [](double t) {
    return t < 2.05 ? std::optional(Twist2{0.8, 0.0}) : std::nullopt;
  });
  EXPECT_NEAR(at(list, 2.0), 0.8, 1e-6);
  EXPECT_NEAR(at(list, 2.2), 0.8, 1e-6);          // the command of 2.0 s is 200 ms old
  EXPECT_NEAR(at(list, 2.22), 0.8 - 0.04, 1e-6);  // 2 m/s^2 from here
  EXPECT_NEAR(at(list, 2.6), 0.0, 1e-6);
  EXPECT_EQ(list.back(), 0.0);
}

// From 0.8 m/s to rest, commanded at 2 s and heard at the next step: within acc_max 1 m/s^2 and the jerk limit
// more than 0.8 s; where the planner says that it reckoned with stop_deceleration, 2 m/s^2, 0.4 s. 0.3 s after it
// was last said it does not count: what is left is braked smoothly.
TEST(MotorControlComponent, BrakesHardAsLongAsThePlannerSaysSo) {
  const auto brake = [](double said_until) {
    std::vector<double> list;
    run_with_script("components: {motor_control: {}}", 4.0, [&](bw::Setup& setup) {
      setup.input<sensor_msgs::msg::JointState>(
          "wheel_commands", Qos::standard(50), [&](const auto& message, const Tick&) {
            const WheelSpeeds wheels = wheel_speeds_of(message, {kRadius, kRadius}).value();
            list.push_back((wheels.left + wheels.right) / 2.0);
          });
      setup.every(Duration::milliseconds(100), "wish",
                  [said_until, out = setup.command<geometry_msgs::msg::Twist>("cmd_vel"),
                   hard = setup.output<std_msgs::msg::Bool>("brake_hard")](const Tick& tick) mutable {
                    const double t = seconds_since_start(tick.now);
                    if (t > 1.95 && t < said_until) {
                      std_msgs::msg::Bool message;
                      message.data(true);
                      hard.publish(message);
                    }
                    out.publish(to_twist_message({t < 1.95 ? 0.8 : 0.0, 0.0}));
                  });
    });
    return list;
  };
  const auto smooth = brake(0.0), hard = brake(4.0), told_once = brake(2.05);
  EXPECT_NEAR(at(smooth, 1.9), 0.8, 1e-6);
  EXPECT_GT(at(smooth, 2.5), 0.35);
  EXPECT_NEAR(at(hard, 2.2), 0.4, 0.05);
  EXPECT_NEAR(at(hard, 2.46), 0.0, 1e-6);
  EXPECT_NEAR(at(told_once, 2.2), at(hard, 2.2), 1e-6);
  EXPECT_GT(at(told_once, 2.46), 0.05);
}

// Straight on at one ground speed, the larger wheel rotates slower: rates as 1 to 1.01.
TEST(MotorControlComponent, TurnsWheelsOfTwoSizesAtTheirOwnRates) {
  std::vector<double> rates;
  run_with_script(
      "{robot: {wheel_radius_ratio: 1.01}, components: {motor_control: {}}}", 1.0, [&](bw::Setup& setup) {
        setup.input<sensor_msgs::msg::JointState>("wheel_commands", Qos::standard(50),
                                                  [&](const auto& m, const Tick&) { rates = m.velocity(); });
        setup.every(Duration::milliseconds(100), "wish",
                    [out = setup.command<geometry_msgs::msg::Twist>("cmd_vel")](const Tick&) {
                      out.publish(to_twist_message({0.3, 0.0}));
                    });
      });
  ASSERT_EQ(rates.size(), 2U);
  ASSERT_GT(rates[1], 0.1);
  EXPECT_NEAR(rates[0] / rates[1], 1.01, 1e-9);
}

TEST(MotorControlComponent, StopsOnACommandThatIsNotFinite) {
  const auto list = speeds(4.0, [](double t) { return Twist2{t < 2.05 ? 0.8 : std::nan(""), 0.0}; });
  EXPECT_NEAR(at(list, 2.1), 0.8, 0.041);
  EXPECT_NEAR(at(list, 2.56), 0.0, 1e-6);
  for (const double v : list) EXPECT_TRUE(std::isfinite(v));
}

// Half a second from 0.8 to 0.3 m/s at 1 m/s^2, and what the jerk limit of 5 m/s^3 adds: 0.2 s at both ends
// together. A command of 5 m/s is 100 times the limit of 0.05, and five times what the robot can do: cut, and
// no fault.
TEST(MotorControlComponent, KeepsASpeedLimitWhateverIsCommanded) {
  const auto list = speeds(
      10.0,
      [](double t) {
        return Twist2{t < 4.05 ? 0.8 : 5.0, 0.0};
      },
      [](double t) -> std::optional<double> {
        if (std::abs(t - 2.0) < 0.01) return 0.3;
        if (std::abs(t - 4.0) < 0.01) return 0.05;
        if (std::abs(t - 6.0) < 0.01) return -1.0;
        if (std::abs(t - 7.0) < 0.01) return 0.0;
        return std::nullopt;
      });
  EXPECT_NEAR(at(list, 2.0), 0.8, 1e-6);
  EXPECT_GT(at(list, 2.3), 0.45);  // no safety stop: within acc_max
  EXPECT_NEAR(at(list, 2.9), 0.3, 1e-3);
  EXPECT_NEAR(at(list, 4.0), 0.3, 1e-6);
  EXPECT_NEAR(at(list, 5.0), 0.05, 1e-3);
  EXPECT_NEAR(at(list, 7.0), 0.05, 1e-6);
  EXPECT_NEAR(at(list, 9.9), 1.0, 1e-3);  // the robot's own
}

// The robot is at full speed when it is deactivated, which is a stop; 40 ms later it is activated, and nobody
// commands any more.
TEST(MotorControlComponent, ActivatedAgainItStaysAtRest) {
  const auto list = speeds(
      3.0,
      [](double t) {
        return t < 2.0 ? std::optional(Twist2{0.8, 0.0}) : std::nullopt;
      },
      [](double) { return std::optional<double>(); }, {{2.01, "deactivate"}, {2.05, "activate"}});
  ASSERT_GT(list.size(), 140U);  // at 50 Hz
  EXPECT_NEAR(at(list, 2.0), 0.8, 1e-6);
  for (std::size_t i = 100; i < list.size(); ++i) EXPECT_EQ(list[i], 0.0) << i;
}

}  // namespace
}  // namespace bw
