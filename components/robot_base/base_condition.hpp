// Whether and why a base does not drive: the numbers of bandwagon_msgs/BaseState, and the causes of a stop
// among them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace bw {

/// Why it has to stand, the gravest first.
enum class StopCause : std::uint8_t {
  emergency_stop,
  wheel_drop,
  cliff,
  bumper,
  runaway,
  stall,
  link,
  device,
  battery,
  charging,
};
inline constexpr std::size_t kStopCauses = 10;

enum class BaseCondition : std::uint8_t {
  driving = 0,
  waiting = 1,
  backing_off = 2,
  emergency_stop = 3,
  bumper = 4,
  cliff = 5,
  wheel_drop = 6,
  stall = 7,
  runaway = 8,
  link = 9,
  device = 10,
  battery = 11,
  charging = 12,
};

constexpr BaseCondition condition_of(StopCause cause) {
  constexpr std::array<BaseCondition, kStopCauses> kConditions = {
      BaseCondition::emergency_stop, BaseCondition::wheel_drop, BaseCondition::cliff, BaseCondition::bumper,
      BaseCondition::runaway,        BaseCondition::stall,      BaseCondition::link,  BaseCondition::device,
      BaseCondition::battery,        BaseCondition::charging};
  return kConditions[static_cast<std::size_t>(cause)];
}

}  // namespace bw
