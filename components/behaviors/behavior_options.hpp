// Parameters of the behaviors. Names as in Nav2's behavior_server where it has the same thing.
#pragma once

#include <optional>
#include <string>

#include "components/model/stamped_choice.hpp"
#include "runtime/base/field.hpp"

namespace bw {

struct BehaviorOptions {
  double cycle_frequency = 10.0;
  double simulate_ahead_time = 2.0;
  double max_rotational_vel = 1.0;
  double min_rotational_vel = 0.1;
  double rotational_acc_lim = 3.2;
  /// [m/s] backup and drive_on_heading drive no slower but for their last step, unless the goal asks for it
  static constexpr double kMinimumSpeed = 0.02;
  /// [m] gap that the look-ahead asks for around the footprint
  static constexpr double kCollisionMargin = 0.02;
  double command_lead = 0.2;
  double movement_time_allowance = 10.0;
  StampedCmdVel enable_stamped_cmd_vel = StampedCmdVel::no;

  template <class Visitor>
  void fields(Visitor& v) {
    v("cycle_frequency", cycle_frequency, {.unit = "Hz", .min = 2, .max = 100, .doc = "commands per second"});
    v("simulate_ahead_time", simulate_ahead_time,
      {.unit = "s",
       .min = 0,
       .max = 10,
       .doc = "how far ahead the motion must be free; at least the time to come to rest"});
    v("max_rotational_vel", max_rotational_vel,
      {.unit = "rad/s", .min = 0.01, .max = 20, .doc = "turn rate of spin; at most the robot's own"});
    v("min_rotational_vel", min_rotational_vel,
      {.unit = "rad/s",
       .min = 0,
       .max = 20,
       .doc = "spin turns no slower but for its last step; what the base needs to move at all"});
    v("rotational_acc_lim", rotational_acc_lim,
      {.unit = "rad/s^2", .min = 0.01, .max = 50, .doc = "of spin; at most the robot's own"});
    v("command_lead", command_lead,
      {.unit = "s",
       .min = 0.005,
       .max = 1,
       .doc = "time from odometry to wheels that obey; raise it when motions pass their target"});
    v("movement_time_allowance", movement_time_allowance,
      {.unit = "s",
       .min = 0.5,
       .max = 600,
       .doc = "a goal without an allowance of its own fails when the robot has not moved for so long"});
    v("enable_stamped_cmd_vel", enable_stamped_cmd_vel,
      {.doc =
           "commands are TwistStamped, no Twist; auto: as Nav2 of the graph's ros_distro has it, true from Kilted on"});
  }
  std::optional<std::string> violated_rule() const {
    if (min_rotational_vel > max_rotational_vel)
      return "min_rotational_vel must be at most max_rotational_vel";
    if (command_lead * cycle_frequency < 0.5)
      return "command_lead must be at least half of the time between two commands";
    return std::nullopt;
  }
};

}  // namespace bw
