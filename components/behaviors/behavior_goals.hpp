// From what a goal asks for to the behavior that does it. A goal that asks for what is none becomes a
// behavior that fails at its first step.
#pragma once

#include <memory>

#include "components/behaviors/behavior.hpp"
#include "components/behaviors/behavior_options.hpp"
#include "components/model/limits.hpp"

namespace bw {

/// Counter-clockwise by target_yaw [rad], which may be several revolutions.
struct SpinGoal {
  double target_yaw = 0.0;
  Duration time_allowance;  ///< 0 or less: none
  bool disable_collision_checks = false;
};

/// Along x by target.x() [m] at `speed` [m/s].
struct DriveGoal {
  Vector2 target{0.0, 0.0};
  double target_z = 0.0;
  double speed = 0.0;
  Duration time_allowance;  ///< 0 or less: none
  bool disable_collision_checks = false;
};

/// At most as fast and as hard as `options` and the robot allow.
std::unique_ptr<Behavior> make_spin(const SpinGoal& goal, const BehaviorOptions& options, Time accepted);
/// target.x and speed have the same sign; backward is slower where the robot's limits say so.
std::unique_ptr<Behavior> make_drive_on_heading(const DriveGoal& goal, const BehaviorOptions& options,
                                                const Limits& limits, Time accepted);
/// Backward whatever the signs of target.x and speed are.
std::unique_ptr<Behavior> make_back_up(const DriveGoal& goal, const BehaviorOptions& options,
                                       const Limits& limits, Time accepted);

}  // namespace bw
