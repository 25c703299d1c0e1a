// What a button of the emergency stop says.
#pragma once

#include <std_msgs/msg/bool.hpp>

namespace bw {

inline std_msgs::msg::Bool pressed(bool is_pressed) {
  std_msgs::msg::Bool message;
  message.data(is_pressed);
  return message;
}

}  // namespace bw
