// Whether commands carry a stamp, in the words of Nav2's parameter enable_stamped_cmd_vel.
#pragma once

#include "runtime/base/choice.hpp"
#include "runtime/base/ros_distro.hpp"

namespace bw {

enum class StampedCmdVel { no, yes, automatic };
constexpr auto choice_table(StampedCmdVel) {
  using enum StampedCmdVel;
  return choices<StampedCmdVel>({{no, "false"}, {yes, "true"}, {automatic, "auto"}});
}

/// Nav2's default is false up to Jazzy, and true from Kilted on.
constexpr bool is_stamped(StampedCmdVel choice, RosDistro distro) {
  if (choice != StampedCmdVel::automatic) return choice == StampedCmdVel::yes;
  return distro == RosDistro::kilted || distro == RosDistro::lyrical;
}

}  // namespace bw
