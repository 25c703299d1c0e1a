// The robot's limits under the newest limit on topic `speed_limit`. For adaptors only.
#pragma once

#include <string>

#include <nav2_msgs/msg/speed_limit.hpp>

#include "components/model/limits.hpp"
#include "components/model/speed_limit.hpp"
#include "runtime/complaint.hpp"
#include "runtime/component.hpp"

namespace bw {

/// Lives in the component whose setup it is given.
class LimitedSpeed {
 public:
  void listen(Setup& setup, const Limits& own) {
    own_ = limits_ = own;
    log_ = setup.log();
    setup.input<nav2_msgs::msg::SpeedLimit>(
        "speed_limit", Qos::standard(), [this](const auto& message, const Tick&) { take(message); },
        Need::optional);
  }
  const Limits& limits() const { return limits_; }

 private:
  void take(const nav2_msgs::msg::SpeedLimit& message) {
    const SpeedLimit limit{message.percentage(), message.speed_limit()};
    const std::string fault = fault_of(limit);
    if (fault_.is_news(fault) && fault_) log_.warn("a speed limit of {} is not used: {}", limit.value, fault);
    if (fault_) return;
    const double before = limits_.v_max;
    limits_ = limited(own_, limit);
    if (limits_.v_max != before) log_.info("at most {:.2f} m/s from now on", limits_.v_max);
  }

  Limits own_;
  Limits limits_;
  Complaint fault_;
  Logger log_;
};

}  // namespace bw
