// Commands of velocity: a Twist, or a TwistStamped of base_link where Nav2's neighbours want one. For
// adaptors only.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include <geometry_msgs/msg/twist.hpp>
#include <geometry_msgs/msg/twist_stamped.hpp>

#include "components/messages/geometry.hpp"
#include "runtime/component.hpp"

namespace bw {

class VelocityOutput {
 public:
  void offer(Setup& setup, const std::string& topic, bool is_stamped) {
    base_frame_ = setup.frame("base_link");
    if (is_stamped) {
      stamped_ = setup.command<geometry_msgs::msg::TwistStamped>(topic);
    } else {
      plain_ = setup.command<geometry_msgs::msg::Twist>(topic);
    }
  }
  void publish(const Twist2& twist, Time now) const {
    if (plain_) return plain_->publish(to_twist_message(twist));
    geometry_msgs::msg::TwistStamped message;
    message.header(make_header(base_frame_, now));
    message.twist(to_twist_message(twist));
    stamped_->publish(message);
  }

 private:
  std::string base_frame_;
  std::optional<Output<geometry_msgs::msg::Twist>> plain_;
  std::optional<Output<geometry_msgs::msg::TwistStamped>> stamped_;
};

/// Hears wanted velocities of either type.
inline void input_velocity(Setup& setup, const std::string& topic, bool is_stamped,
                           std::function<void(const Twist2& twist, const Tick& tick)> on_velocity) {
  if (is_stamped) {
    setup.input<geometry_msgs::msg::TwistStamped>(
        topic, Qos::command(), [on_velocity = std::move(on_velocity)](const auto& message, const Tick& tick) {
          on_velocity(from_twist(message.twist()), tick);
        });
  } else {
    setup.input<geometry_msgs::msg::Twist>(
        topic, Qos::command(), [on_velocity = std::move(on_velocity)](const auto& message, const Tick& tick) {
          on_velocity(from_twist(message), tick);
        });
  }
}

}  // namespace bw
