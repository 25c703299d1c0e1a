// What a base tells beside its odometry, as messages. For the adaptor only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <bandwagon_msgs/msg/base_state.hpp>
#include <sensor_msgs/msg/battery_state.hpp>
#include <sensor_msgs/msg/imu.hpp>
#include <sensor_msgs/msg/range.hpp>

#include "components/robot_base/base_guard.hpp"
#include "components/robot_base/driver.hpp"
#include "runtime/component.hpp"

namespace bw {

class BaseOutputs {
 public:
  BaseOutputs() = default;
  /// Topics of what the base has, and `base_state`.
  BaseOutputs(Setup& setup, const Driver& driver);

  void publish(Time now, const Readings& readings);
  /// `measured`: ground speeds of the wheels.
  void publish_state(Time now, const BaseOutput& output, const ContactReading& contacts,
                     const WheelSpeeds& measured);
  /// Buttons or cable are not as they were told.
  bool is_news() const { return is_news_; }
  const std::string& device() const { return state_.device(); }

 private:
  /// Once a second, and when a charger comes or goes.
  void publish_battery(Time now, const BatteryReading& reading);
  void publish_gyro(const GyroReading& reading);
  void publish_range(const RangeReading& reading);

  bool has_gyro_ = false, has_battery_ = false;
  std::string base_frame_;
  bandwagon_msgs::msg::BaseState state_;
  bool is_news_ = false;
  Output<bandwagon_msgs::msg::BaseState> states_;
  sensor_msgs::msg::BatteryState battery_message_;
  std::optional<Time> battery_told_;
  Output<sensor_msgs::msg::BatteryState> battery_;
  Output<sensor_msgs::msg::Imu> imu_;
  struct Beam {
    sensor_msgs::msg::Range message;
    Output<sensor_msgs::msg::Range> output;
  };
  std::vector<Beam> beams_;
};

}  // namespace bw
