// Messages as the bytes a bag holds.
#pragma once

#include <cstdint>
#include <vector>

#include <geometry_msgs/msg/twist_stamped.hpp>

#include "runtime/stamps.hpp"
#include "runtime/wire/serialization.hpp"

namespace bw::replay {

template <class Message>
std::vector<std::uint8_t> bytes_of(const Message& message) {
  std::vector<std::uint8_t> cdr;
  serialize(message, cdr);
  return cdr;
}

inline std::vector<std::uint8_t> twist(double stamp_s, double x, double z = 0.0) {
  geometry_msgs::msg::TwistStamped message;
  message.header().stamp(to_stamp(Time::seconds(stamp_s)));
  message.twist().linear().x(x);
  message.twist().angular().z(z);
  return bytes_of(message);
}

}  // namespace bw::replay
