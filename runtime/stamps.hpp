// Between our times and the stamps of messages.
#pragma once

#include <builtin_interfaces/msg/duration.hpp>
#include <builtin_interfaces/msg/time.hpp>

#include "runtime/base/time.hpp"

namespace bw {

inline builtin_interfaces::msg::Time to_stamp(Time t) {
  builtin_interfaces::msg::Time stamp;
  stamp.sec(static_cast<std::int32_t>(t.nanoseconds / 1'000'000'000));
  stamp.nanosec(static_cast<std::uint32_t>(t.nanoseconds % 1'000'000'000));
  return stamp;
}

inline Time from_stamp(const builtin_interfaces::msg::Time& stamp) {
  return {stamp.sec() * std::int64_t{1'000'000'000} + stamp.nanosec()};
}

inline builtin_interfaces::msg::Duration to_message(Duration d) {
  builtin_interfaces::msg::Duration message;
  message.sec(static_cast<std::int32_t>(d.nanoseconds / 1'000'000'000));
  message.nanosec(static_cast<std::uint32_t>(d.nanoseconds % 1'000'000'000));
  return message;
}

}  // namespace bw
